// Reads a picture as it is displayed, and writes one aside before it takes its place.
#include "Picture/PictureFile.h"

#include "Picture/Srgb.h"
#include "Text/AsideFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace Drydock
{

namespace
{

double ToDisplay(double Value, bool bEightBit, bool bEncoded)
{
	const double Clamped = Value > 0.0 ? std::min(Value, 1.0) : 0.0;
	const double Display = bEncoded ? Clamped : EncodeSrgb(Clamped);
	return bEightBit ? std::round(Display * 255.0) / 255.0 : Display; // reading decoded it
}

/** Red, green and blue; the first channel thrice where there are none. */
std::vector<int> FindColor(const FImageFile& File)
{
	std::vector<int> Indices = {File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")};
	if (std::find(Indices.begin(), Indices.end(), -1) != Indices.end())
	{
		Indices = {0, 0, 0};
	}
	return Indices;
}

} // namespace

FImage ReadPicture(const std::string& Path)
{
	FImageFile File(Path);
	const std::vector<std::vector<float>> Planes = File.Read(FindColor(File));
	const bool bEncoded = File.GetAttribute("drydock:encoding") == "sRGB";
	FImage Picture{File.GetWidth(), File.GetHeight(), 3, {}};
	Picture.Values.reserve(Planes[0].size() * 3);
	for (size_t Index = 0; Index < Planes[0].size(); ++Index)
	{
		for (const std::vector<float>& Plane : Planes)
		{
			Picture.Values.push_back(ToDisplay(static_cast<double>(Plane[Index]), File.IsEncoded(), bEncoded));
		}
	}
	return Picture;
}

void WritePicture(const std::string& Path, const FImage& Picture)
{
	FAsideFile Aside{std::filesystem::path(Path)};
	WritePng(Aside.GetPath().string(), Picture, EPngEffort::Small);
	Aside.PutInPlace();
}

} // namespace Drydock
