// Writes OpenEXR files by OpenEXR itself, band by band, so that no second copy of a picture is held. No date: equal
// pictures give equal bytes.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageReader.h"

#include <functional>

namespace Drydock
{

/** The attribute of OpenEXR for primaries and white, here by name: "Rec.709" or "Rec.2020". */
constexpr const char* ChromaticitiesName = "chromaticities";

/** The header of an EXR file. */
struct FExrDescription
{
	int Width = 0;
	int Height = 0;
	std::vector<std::string> Channels;
	std::vector<bool> Half; // of each channel: half floats, else 32-bit floats
	std::map<std::string, std::string> Attributes;
	FImageWindow Window;
};

/** Gives row Y, channels interleaved in the description's order. Called from several threads, each row once. */
using FRowSource = std::function<void(int Y, float* Row)>;

/** Lossless: PIZ where all channels are half floats, else ZIP. Throws FError (exit code 3) when it cannot be written.
 */
DRYDOCK_API void WriteExrRows(const std::string& Path, const FExrDescription& Description, const FRowSource& Rows);

/** The same of whole planes: each channel is half where all its values are. */
DRYDOCK_API void WriteExrPlanes(const std::string& Path, int Width, int Height,
	const std::vector<std::vector<float>>& Planes, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes);

/** Whether the value is finite and a half float holds it. */
bool IsExactHalf(double Value);

} // namespace Drydock
