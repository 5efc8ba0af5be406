// Reads the layers of a frame's files from their headers: their names, the files they belong to, and their channels. No
// pixel is read.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageFile.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

struct FImportChannel
{
	std::string Name;      // as in the file: "FinalImageWorldNormal.R"
	int Slot = 0;          // red or x 0, green or y 1, blue or z 2, alpha or w 3
	int Index = 0;         // in its part of the file
	double Greatest = 0.0; // of whole numbers, which are read as parts of it; 0: floats
};

struct FImportLayer
{
	size_t File = 0;
	int Part = 0;
	std::string Name;       // "FinalImageWorldNormal", "ViewLayer.Depth"; empty: the file's main picture
	std::string Label = {}; // what it is called in messages and by --map: its name, or the file's
	std::string Hint = {};  // what its meaning is guessed from: its name, or the file's without the number of a frame
	std::vector<FImportChannel> Channels = {}; // by slot, each once

	/** Null where it has none there. */
	DRYDOCK_API const FImportChannel* Find(int Slot) const;
};

struct FImportPart
{
	int Width = 0;
	int Height = 0;
	FImageWindow Window;

	/** Width of the picture that the part belongs to. */
	int GetFullWidth() const { return Window.FullWidth > 0 ? Window.FullWidth : Width; }
	int GetFullHeight() const { return Window.FullHeight > 0 ? Window.FullHeight : Height; }
};

struct FImportFile
{
	std::string Path;
	std::vector<FImportPart> Parts = {};
	std::map<std::string, std::string> Attributes = {}; // texts of all parts' headers; the first part's win
	std::vector<float> Chromaticities = {}; // x, y of red, green, blue and white; empty: the file does not say
	bool bEncoded = false;                  // as a PNG
};

struct FImportLayers
{
	std::vector<FImportFile> Files;
	std::vector<FImportLayer> Layers; // in the order of the files and their channels
};

/** A channel of a layer. */
struct FImportSource
{
	size_t Layer = 0;
	int Slot = 0;

	bool operator==(const FImportSource&) const = default;
};

/** A channel's name as its layer and its slot; the slot is -1 where the last word is not a component. */
struct FImportChannelName
{
	std::string Layer;
	int Slot = -1;

	bool operator==(const FImportChannelName&) const = default;
};

/** Splits "FinalImageWorldNormal.R", "ViewLayer.Depth.Z" or "R"; what Unreal 5.3 on Linux puts behind the letter is
 * left out. */
DRYDOCK_API FImportChannelName SplitChannelName(const std::string& Name);

/** A file's name without folder, extension and a frame's number: it may name the pass that the file holds. */
DRYDOCK_API std::string GetPassOfFile(const std::string& Path);

/** Reads the headers. Throws FError (exit code 3) where a file cannot be read. */
DRYDOCK_API FImportLayers ReadImportLayers(const std::vector<std::string>& Paths);

} // namespace Drydock
