// Measures the frames of a sequence one after another, and puts them into one JSON.
#include "Report/SequencePage.h"

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "Picture/Srgb.h"
#include "Report/ReportPng.h"
#include "Sequence/SequenceSheet.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/Version.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

namespace Drydock
{

namespace
{

constexpr size_t MaxFrames = 96; // that have pictures
constexpr int MaxWidth = 480;    // of a picture

struct FFrameFigures
{
	double Mean = 0.0;            // of the luminance that the display shows, 0..1
	double White = 0.0;           // share of the pixels with a channel at its largest code
	std::optional<double> Change; // RMS of the difference from the frame before, of codes 0..1
};

FFrameFigures MeasureFrame(const FImage& Picture, const FImage& Before)
{
	FFrameFigures Figures;
	const size_t NumPixels = Picture.Values.size() / 3;
	for (size_t At = 0; At < Picture.Values.size(); At += 3)
	{
		const double* const Code = &Picture.Values[At];
		Figures.Mean += 0.2126 * DecodeSrgb(Code[0]) + 0.7152 * DecodeSrgb(Code[1]) + 0.0722 * DecodeSrgb(Code[2]);
		Figures.White += std::max({Code[0], Code[1], Code[2]}) >= 1.0 ? 1.0 : 0.0;
	}
	Figures.Mean /= static_cast<double>(NumPixels);
	Figures.White /= static_cast<double>(NumPixels);
	if (Before.Values.size() == Picture.Values.size())
	{
		double Sum = 0.0;
		for (size_t At = 0; At < Picture.Values.size(); ++At)
		{
			const double Difference = Picture.Values[At] - Before.Values[At];
			Sum += Difference * Difference;
		}
		Figures.Change = std::sqrt(Sum / static_cast<double>(Picture.Values.size()));
	}
	return Figures;
}

/** Time of the passes, by the frame's timing.json; none if there is no such file. */
std::optional<double> ReadMilliseconds(const std::filesystem::path& Folder)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const std::string Text = TryReadTextFile((Folder / "timing.json").string()).value_or("");
	const FJsonValue Root = ParseJson(Text, "", Ignored, bSyntaxError);
	const bool bKnown = !bSyntaxError && Root.Find("executeMs") != nullptr;
	return bKnown ? std::optional(Root.GetNumber("executeMs", 0.0)) : std::nullopt;
}

FReportPicture MakeFramePicture(const FImage& Image, int Frame)
{
	FReportPicture Picture;
	Picture.Id = std::to_string(Frame);
	Picture.Role = "frame";
	Picture.Label = "Frame " + std::to_string(Frame);
	Picture.Extent = Picture.Size = {Image.Width, Image.Height};
	Picture.Channels = {"R", "G", "B"};
	Picture.Png = MakePng(Image.Width > MaxWidth ? ScalePicture(Image, MaxWidth) : Image, true);
	return Picture;
}

} // namespace

std::string MakeSequencePageData(
	const FSequenceResult& Result, const std::string& Name, const std::string& WalkJson, const std::string& When)
{
	const std::vector<size_t> Chosen = ChooseSheetFrames(Result.Frames.size(), MaxFrames);
	const std::set<size_t> Shown(Chosen.begin(), Chosen.end());
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "sequence"}, {"name", Name},
		{"version", GetVersion()}, {"written", When}, {"framesPerSecond", Result.FramesPerSecond}});
	Writer.Key("sequence").Raw(Result.SequenceJson);
	Writer.RawMember("walk", WalkJson);
	std::vector<FReportPicture> Pictures;
	FImage Before;
	Writer.Key("figures").BeginArray();
	for (size_t Index = 0; Index < Result.Frames.size(); ++Index)
	{
		FImage Image = ReadPicture(Result.Pictures[Index]);
		const FFrameFigures Figures = MeasureFrame(Image, Before);
		Writer.Object({{"frame", Result.Frames[Index]}, {"mean", Figures.Mean}, {"white", Figures.White},
			{"change", Figures.Change},
			{"ms", ReadMilliseconds(std::filesystem::path(Result.Pictures[Index]).parent_path())}});
		if (Shown.count(Index) > 0)
		{
			Pictures.push_back(MakeFramePicture(Image, Result.Frames[Index]));
		}
		Before = std::move(Image);
	}
	Writer.EndArray();
	std::vector<size_t> All(Pictures.size());
	std::iota(All.begin(), All.end(), 0);
	FitPictures(Pictures, {All}, MaxPagePictureBytes);
	WriteReportPictures(Writer, Pictures);
	return Writer.GetText();
}

} // namespace Drydock
