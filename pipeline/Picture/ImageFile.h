// Pictures in files: multi-layer EXR, and plain RGB formats, by OpenImageIO. Reading goes in two steps, header first,
// so that a run decodes only what it needs. Written files hold no date: equal pictures give equal bytes.
#pragma once

#include "Diagnostics.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

/** Row-major, channels interleaved. Doubles hold every texture format exactly. */
struct FImage
{
	int Width = 0;
	int Height = 0;
	int NumChannels = 0;
	std::vector<double> Values;

	double Get(int X, int Y, int Channel) const
	{
		return Values[(static_cast<size_t>(Y) * static_cast<size_t>(Width) + static_cast<size_t>(X)) *
						  static_cast<size_t>(NumChannels) +
					  static_cast<size_t>(Channel)];
	}
};

/** Where an image lies in a larger one, of which only this part is in the file: an EXR's data window in its display
 * window. Pixels. */
struct FImageWindow
{
	int X = 0;
	int Y = 0;
	int FullWidth = 0; // 0: the image is the whole
	int FullHeight = 0;

	bool operator==(const FImageWindow&) const = default;
};

/** An image file of which the header has been read. */
class DRYDOCK_API FImageFile
{
public:
	/** Throws FError (exit code 3): missing, no image, or larger than any frame. */
	explicit FImageFile(const std::string& InPath);
	~FImageFile();
	FImageFile(const FImageFile&) = delete;
	FImageFile& operator=(const FImageFile&) = delete;

	const std::string& GetPath() const { return Path; }
	int GetWidth() const { return Width; }
	int GetHeight() const { return Height; }
	/** Where these pixels lie in the picture that the file stands for; with FullWidth and FullHeight. */
	const FImageWindow& GetWindow() const { return Window; }
	/** Names as in the file: "R", "depth.Z". */
	const std::vector<std::string>& GetChannels() const { return Channels; }
	/** -1 when there is none of this name. */
	int FindChannel(const std::string& Name) const;
	/** Text attribute of the header, or empty. */
	std::string GetAttribute(const std::string& Name) const;
	/** Whether values are sRGB-encoded, as in PNG; Read decodes colour. */
	bool IsEncoded() const { return bEncoded; }

	/** One read of the channels with these indices, each a plane of Width * Height linear values, row-major. Throws
	 * FError (exit code 3) when the file is truncated or corrupt. */
	std::vector<std::vector<float>> Read(const std::vector<int>& ChannelIndices);

private:
	struct FInput;

	std::string Path;
	std::unique_ptr<FInput> Input;
	int Width = 0;
	int Height = 0;
	FImageWindow Window;
	std::vector<std::string> Channels;
	bool bEncoded = false;
};

/** Lossless ZIP, no date; half float channels where every value is one, else 32-bit float. Throws FError (exit code 3)
 * when it cannot be written. */
DRYDOCK_API void WriteExr(const std::string& Path, const FImage& Image, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes = {}, const FImageWindow& Window = {});

/** 8 bits per channel, one to four channels; values are display-encoded, clamped to 0..1 (NaN to 0) and rounded to
 * nearest. Compression: 1 to 9; 3 is a few percent larger than 6 and twice as fast. Throws FError (exit code 3) when it
 * cannot be written. */
DRYDOCK_API void WritePng(const std::string& Path, const FImage& Image, int Compression = 3);

} // namespace Drydock
