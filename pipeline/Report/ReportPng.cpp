// Writes pictures into a temporary folder and reads them back.
#include "Report/ReportPng.h"

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "Picture/Preview.h"
#include "TemporaryFolder.h"
#include "Text/TextFile.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr int MinWidth = 128; // of what is halved

int GetPngWidth(const std::string& Png)
{
	constexpr size_t At = 16; // of the width, big-endian, in every PNG's first chunk
	int Width = 0;
	for (size_t Byte = At; Byte < At + 4 && Byte < Png.size(); ++Byte)
	{
		Width = Width << 8 | static_cast<uint8_t>(Png[Byte]);
	}
	return Width;
}

/** Red, green and blue, or one channel: a PNG takes a second or fourth one for alpha. */
FImage KeepColors(const FImage& Image)
{
	const int NumShown = Image.NumChannels == 1 ? 1 : 3;
	FImage Colors{Image.Width, Image.Height, NumShown, {}};
	Colors.Values.reserve(Image.Values.size());
	for (size_t From = 0; From < Image.Values.size(); From += static_cast<size_t>(Image.NumChannels))
	{
		for (int Channel = 0; Channel < NumShown; ++Channel)
		{
			const size_t At = From + static_cast<size_t>(Channel);
			Colors.Values.push_back(Channel < Image.NumChannels ? Image.Values[At] : 0.0);
		}
	}
	return Colors;
}

} // namespace

std::string MakePng(const std::function<void(const std::string& File)>& Write)
{
	const FTemporaryFolder Folder;
	const std::string File = Folder.Reserve("picture.png");
	Write(File);
	return ReadTextFile(File, "cannot be read", MaxBinaryBytes);
}

std::string MakePng(const FImage& Image, bool bDisplay)
{
	return MakePng(
		[&](const std::string& File) { bDisplay ? WritePng(File, KeepColors(Image)) : WritePreviewPng(File, Image); });
}

std::string HalvePng(const std::string& Png)
{
	const FTemporaryFolder Folder;
	const FImage Picture = ReadPicture(Folder.WriteFile("picture.png", Png));
	return MakePng(ScalePicture(Picture, std::max(1, Picture.Width / 2)), true);
}

void FitPictures(std::vector<FReportPicture>& Pictures, const std::vector<std::vector<size_t>>& Groups, size_t MaxBytes)
{
	const auto Weigh = [&](const std::vector<size_t>& Group)
	{
		size_t Bytes = 0;
		for (const size_t Index : Group)
		{
			Bytes += Pictures[Index].Png.size();
		}
		return Bytes;
	};
	const auto CanHalve = [&](const std::vector<size_t>& Group)
	{
		return std::any_of(
			Group.begin(), Group.end(), [&](size_t Index) { return GetPngWidth(Pictures[Index].Png) >= 2 * MinWidth; });
	};
	while (true)
	{
		size_t Total = 0;
		const std::vector<size_t>* Largest = nullptr;
		for (const std::vector<size_t>& Group : Groups)
		{
			const size_t Bytes = Weigh(Group);
			Total += Bytes;
			if (CanHalve(Group) && (Largest == nullptr || Bytes > Weigh(*Largest)))
			{
				Largest = &Group;
			}
		}
		if (Total <= MaxBytes || Largest == nullptr)
		{
			return;
		}
		for (const size_t Index : *Largest)
		{
			Pictures[Index].Png = HalvePng(Pictures[Index].Png);
		}
	}
}

} // namespace Drydock
