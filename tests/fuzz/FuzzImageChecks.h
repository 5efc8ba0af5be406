// What must hold for any bytes in a file that is called .exr: a picture, or one message. Used by the fuzzer, and by a
// test that runs its corpus.
#pragma once

#include "Text/ConfigErrors.h"
#include "Picture/ImageFile.h"
#include "TemporaryFolder.h"

#include <fstream>
#include <numeric>
#include <string>
#include <vector>

namespace Drydock
{

/** What a run reads of a scene: the header, and the channels in one go unless they are more than MaxValues numbers. */
inline std::string CheckExrFile(const std::string& Path, int64_t MaxValues = int64_t(1) << 21)
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

inline std::string CheckExrBytes(const std::string& Bytes)
{
	static const FTemporaryFolder Folder;
	const std::string Path = Folder.Path + "/fuzzed.exr";
	std::ofstream(Path, std::ios::binary) << Bytes;
	return CheckExrFile(Path);
}

} // namespace Drydock
