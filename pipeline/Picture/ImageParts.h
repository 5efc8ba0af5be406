// Image files of other programs: every part of a multi-part EXR with all that its header says, and EXR files whose
// channels differ in type. A scene is read by FImageFile, which knows one part.
#pragma once

#include "Picture/ImageFile.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

struct FImagePart
{
	std::string Name; // in the file; empty where it has none
	int Width = 0;
	int Height = 0;
	FImageWindow Window; // of these pixels in the picture that the part stands for
	std::vector<std::string> Channels;
	std::vector<double> Greatest; // of each channel: the greatest whole number, which is read as 1; 0: floats
	std::map<std::string, std::string> Attributes; // of text
	std::vector<float> Chromaticities;             // x, y of red, green, blue and white; empty: it does not say
};

/** All parts: one, but for an EXR that has several. Throws FError (exit code 3) as FImageFile does. */
DRYDOCK_API std::vector<FImagePart> ReadImageParts(const std::string& Path);

/** One read of channels of a part, each a plane of Width * Height values as they are stored: colour stays encoded.
 * Throws FError (exit code 3) when the file is truncated or corrupt. */
DRYDOCK_API std::vector<std::vector<float>> ReadImagePlanes(
	const std::string& Path, int Part, const std::vector<int>& ChannelIndices);

/** Lossless ZIP, no date; each channel half float where all its values are, else 32-bit float. Throws FError (exit code
 * 3) when it cannot be written. */
DRYDOCK_API void WriteExrPlanes(const std::string& Path, int Width, int Height,
	const std::vector<std::vector<float>>& Planes, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes);

} // namespace Drydock
