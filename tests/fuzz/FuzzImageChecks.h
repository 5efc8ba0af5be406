// What must hold for any bytes in an image file: a picture, or one message. Used by the fuzzers, and by a test that
// runs their corpus.
#pragma once

#include "Text/ConfigErrors.h"
#include "Picture/ImageBytes.h"
#include "Picture/ImageFile.h"

#include <numeric>
#include <string>
#include <vector>

namespace Drydock
{

/** What a run reads of a scene: the header, and the channels in one go unless they are more than MaxValues numbers. */
inline std::string CheckImageFile(const std::string& Path, int64_t MaxValues = int64_t(1) << 21)
{
	try
	{
		FImageFile File(Path);
		File.GetAttribute("drydock:camera_json");
		const size_t NumPixels = static_cast<size_t>(File.GetWidth()) * static_cast<size_t>(File.GetHeight());
		std::vector<int> All(File.GetChannels().size());
		std::iota(All.begin(), All.end(), 0);
		if (static_cast<int64_t>(NumPixels * All.size()) > MaxValues)
		{
			return "";
		}
		for (const std::vector<float>& Plane : File.Read(All))
		{
			if (Plane.size() != NumPixels)
			{
				return "a channel of another size than the picture";
			}
		}
	}
	catch (const FError& Error)
	{
		const std::vector<FDiagnostic>& Found = Error.GetDiagnostics();
		const bool bOne = Found.size() == 1 && !Found[0].Message.empty() &&
						  Found[0].Message.find('\n') == std::string::npos && Error.GetExitCode() == ExitFiles;
		return bOne && (Found[0].Code == ErrorImageBroken || Found[0].Code == ErrorImageTooLarge)
				   ? ""
				   : std::string("not one message about an image: ") + Error.what();
	}
	return "";
}

/** From memory, as a file of that name. */
inline std::string CheckImageBytes(const std::string& Name, const std::string& Bytes)
{
	const FImageBytes Memory(Name, Bytes);
	return CheckImageFile(Name, int64_t(1) << 16);
}

inline std::string CheckExrBytes(const std::string& Bytes)
{
	return CheckImageBytes("fuzzed.exr", Bytes);
}

/** Of the format that the first byte is of; Targa, which has none of its own, for all others. */
inline std::string CheckPictureBytes(const std::string& Bytes)
{
	const unsigned char First = Bytes.empty() ? 0 : static_cast<unsigned char>(Bytes[0]);
	return CheckImageBytes(First == 0x89   ? "fuzzed.png"
						   : First == '#'  ? "fuzzed.hdr"
						   : First == 0xFF ? "fuzzed.jpg"
						   : First == 'B'  ? "fuzzed.bmp"
										   : "fuzzed.tga",
		Bytes);
}

} // namespace Drydock
