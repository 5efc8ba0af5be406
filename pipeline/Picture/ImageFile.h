// Pictures in files: multi-layer EXR, and plain RGB formats. Reading goes in two steps, header first, so that a run
// decodes only what it needs. Written files hold no date: equal pictures give equal bytes.
#pragma once

#include "Diagnostics.h"
#include "Picture/ImageReader.h"
#include "Picture/PngWriter.h"
#include "Templates/UnrealTemplate.h"

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

/** The pixels that are the picture of a file. */
enum class EImageExtent : uint8_t
{
	Stored, // those that the file holds
	Display // those of an EXR's display window: what lies outside of it is cut, and what the file lacks of it is 0
};

/** An image file of which the header has been read. */
class DRYDOCK_API FImageFile : private FNoncopyable
{
public:
	/** Throws FError (exit code 3): missing, no image, or larger than any frame. Extent is that of the first part, for
	 * all but ReadPart. */
	explicit FImageFile(const std::string& InPath, EImageExtent Extent = EImageExtent::Stored);
	~FImageFile();

	const std::string& GetPath() const { return Path; }
	int GetWidth() const { return Width; }
	int GetHeight() const { return Height; }
	/** Says in one sentence what Extent cuts and lacks; empty: nothing. */
	std::string DescribeExtent() const;
	/** Position of these pixels in the picture that the file belongs to; with FullWidth and FullHeight. */
	const FImageWindow& GetWindow() const { return GetParts()[0].Window; }
	/** Names as in the file: "R", "depth.Z". */
	const std::vector<std::string>& GetChannels() const { return GetParts()[0].Channels; }
	/** -1 when there is none of this name. */
	int FindChannel(const std::string& Name) const;
	/** Text attribute of the header, or empty. */
	std::string GetAttribute(const std::string& Name) const;
	/** Whether values are sRGB-encoded, as in PNG; Read decodes colour. */
	bool IsEncoded() const { return GetParts()[0].bEncoded; }
	/** All parts: one, but for an EXR that has several. The functions above are about the first. */
	const std::vector<FImagePart>& GetParts() const { return Reader->GetParts(); }

	/** One read of the channels with these indices, each a plane of Width * Height linear values, in the width that
	 * they are stored in. Throws FError (exit code 3) when the file is truncated or corrupt. */
	std::vector<FImagePlane> ReadPlanes(const std::vector<int>& ChannelIndices);

	/** The same as floats. */
	std::vector<std::vector<float>> Read(const std::vector<int>& ChannelIndices);

	/** Channels of any part, values as they are stored: colour stays encoded. Throws as Read does. */
	std::vector<FImagePlane> ReadPart(int Part, const std::vector<int>& ChannelIndices);

private:
	bool IsWhole() const;

	std::string Path;
	std::unique_ptr<IImageReader> Reader;
	int Width = 0;
	int Height = 0;
};

/** Lossless, no date; half float channels where every value is one, else 32-bit float. Throws FError (exit code 3)
 * when it cannot be written. */
DRYDOCK_API void WriteExr(const std::string& Path, const FImage& Image, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes = {}, const FImageWindow& Window = {});

/** 8 bits per channel, one to four channels; values are display-encoded, clamped to 0..1 (NaN to 0) and rounded to
 * nearest. Throws FError (exit code 3) when it cannot be written. */
DRYDOCK_API void WritePng(const std::string& Path, const FImage& Image, EPngEffort Effort = EPngEffort::Quick);

} // namespace Drydock
