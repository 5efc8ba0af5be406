// What must hold for any bytes in an image file: a picture, or one message. Used by the fuzzers, and by a test that
// runs their corpus.
#pragma once

#include "Text/ConfigErrors.h"
#include "Picture/ImageBytes.h"
#include "Picture/ImageFile.h"
#include "Picture/ImagePlane.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace Drydock
{

/** All channels of a part, unless they are more than MaxValues numbers: then none. */
inline std::vector<int> GetChannelsToRead(const FImagePart& Part, int64_t MaxValues)
{
	std::vector<int> All(Part.Channels.size());
	std::iota(All.begin(), All.end(), 0);
	return int64_t(Part.Width) * Part.Height * static_cast<int64_t>(All.size()) > MaxValues ? std::vector<int>() : All;
}

/** Reads a picture as a run, an import and a comparison do: the header, and the channels of every part, all of them in
 * one go and some of them. */
inline std::string CheckImageFile(
	const std::string& Path, int64_t MaxValues = int64_t(1) << 21, EImageExtent Extent = EImageExtent::Stored)
{
	try
	{
		FImageFile File(Path, Extent);
		File.GetAttribute("drydock:camera_json");
		for (size_t Part = 0; Part < File.GetParts().size(); ++Part)
		{
			File.ReadPart(static_cast<int>(Part), GetChannelsToRead(File.GetParts()[Part], MaxValues));
		}
		FImagePart Shown = File.GetParts()[0];
		Shown.Width = std::max(Shown.Width, File.GetWidth());
		Shown.Height = std::max(Shown.Height, File.GetHeight());
		const std::vector<int> All = GetChannelsToRead(Shown, MaxValues);
		const std::vector<std::vector<float>> Planes = File.Read(All);
		std::vector<int> Some; // from the last on, as a pass may want them
		for (int Channel = static_cast<int>(All.size()) - 1; Channel >= 0; Channel -= 2)
		{
			Some.push_back(Channel);
		}
		const std::vector<std::vector<float>> SomePlanes = File.Read(Some);
		for (size_t Index = 0; Index < Some.size(); ++Index)
		{
			const std::vector<float>& Whole = Planes[static_cast<size_t>(Some[Index])];
			const std::vector<float>& Alone = SomePlanes[Index];
			if (Whole.size() != static_cast<size_t>(File.GetWidth()) * static_cast<size_t>(File.GetHeight()))
			{
				return "a channel of another size than the picture";
			}
			if (Alone.size() != Whole.size() ||
				!std::equal(Whole.begin(), Whole.end(), Alone.begin(),
					[](float A, float B) { return std::bit_cast<uint32_t>(A) == std::bit_cast<uint32_t>(B); }))
			{
				return "a channel differs when fewer are read";
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
	const std::string Problem = CheckImageFile(Name, int64_t(1) << 16);
	return Problem.empty() ? CheckImageFile(Name, int64_t(1) << 16, EImageExtent::Display) : Problem;
}

inline std::string CheckExrBytes(const std::string& Bytes)
{
	return CheckImageBytes("fuzzed.exr", Bytes);
}

/** As a file of the format that the first byte is of; Targa, which has none of its own, for all others. */
inline std::string CheckPictureBytes(const std::string& Bytes)
{
	const unsigned char First = Bytes.empty() ? 0 : static_cast<unsigned char>(Bytes[0]);
	return CheckImageBytes(First == 0x89                  ? "fuzzed.png"
						   : First == 0x76                ? "fuzzed.exr"
						   : First == '#'                 ? "fuzzed.hdr"
						   : First == 0xFF                ? "fuzzed.jpg"
						   : First == 'B'                 ? "fuzzed.bmp"
						   : First == 'I' || First == 'M' ? "fuzzed.tif"
						   : First == 'S' || First == 'X' ? "fuzzed.dpx"
														  : "fuzzed.tga",
		Bytes);
}

} // namespace Drydock
