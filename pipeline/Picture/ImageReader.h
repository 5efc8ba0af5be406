// Defines the result of an image reader, for every format: parts with all members of their headers, and channels as
// they are stored. There is one reader for each library: OpenEXR's, libpng's, and OpenImageIO's for all other formats.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

struct FImagePlane;

/** Position of an image in a larger one, of which only this part is in the file: an EXR's data window in its display
 * window. Pixels. */
struct FImageWindow
{
	int X = 0;
	int Y = 0;
	int FullWidth = 0; // 0: the image is the whole
	int FullHeight = 0;

	bool operator==(const FImageWindow&) const = default;
};

/** One picture of a file: EXR files may have several. */
struct FImagePart
{
	std::string Name; // in the file; empty where it has none
	int Width = 0;
	int Height = 0;
	FImageWindow Window;               // of these pixels in the picture that the part stands for
	std::vector<std::string> Channels; // layer by layer, red before green before blue before alpha
	std::vector<double> Greatest;      // of each channel: the greatest whole number, which is read as 1; 0: floats
	std::map<std::string, std::string> Attributes; // of text
	std::vector<float> Chromaticities;             // x, y of red, green, blue and white; empty: it does not say
	bool bEncoded = false;                         // colour is sRGB-encoded
	bool bFilmLog = false;                         // colour is Kodak's printing density (Cineon), scaled to 0..1
};

/** A file whose header has been read. Errors of its functions are std::exception with the library's own words. */
class IImageReader
{
public:
	virtual ~IImageReader() = default;

	/** One at least. */
	virtual const std::vector<FImagePart>& GetParts() const = 0;

	/** The channels with these indices, once through the file. */
	virtual std::vector<FImagePlane> Read(int Part, const std::vector<int>& Channels) = 0;
};

/** The bytes of a file that lies in memory; null: it lies on the disk. They live as long as the reader. */
using FImageBytesPointer = const std::string*;

} // namespace Drydock
