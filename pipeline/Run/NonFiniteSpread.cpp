// Counts what passes write that is not finite, and says it in a sentence.
#include "Run/NonFiniteSpread.h"

#include "RenderGraphPass.h"
#include "RenderGraphResources.h"
#include "Run/VariableTaps.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "TextTools.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Steps below a thousandth of the picture are the reach of a few taps. */
constexpr double SmallestStep = 0.001;
constexpr size_t NumNamed = 3;

struct FStep
{
	const FNonFiniteFootprint* Pass;
	double Growth;
};

/** The largest steps, in the order of the passes. */
std::vector<FStep> FindLargestSteps(const FNonFiniteSpread& Spread)
{
	std::vector<FStep> Steps;
	double Before = 0.0;
	for (const FNonFiniteFootprint& Pass : Spread.Passes)
	{
		Steps.push_back({&Pass, Pass.GetShare() - Before});
		Before = Pass.GetShare();
	}
	std::erase_if(Steps, [](const FStep& Step) { return Step.Growth < SmallestStep; });
	std::stable_sort(Steps.begin(), Steps.end(), [](const FStep& A, const FStep& B) { return A.Growth > B.Growth; });
	Steps.resize(std::min(Steps.size(), NumNamed));
	std::sort(Steps.begin(), Steps.end(), [](const FStep& A, const FStep& B) { return A.Pass < B.Pass; });
	return Steps;
}

std::string FormatShare(uint64_t Pixels, uint64_t NumPixels)
{
	return fmt::format("{:.3g} %", 100.0 * static_cast<double>(Pixels) / static_cast<double>(NumPixels));
}

/** Checks one pixel; alpha is last. */
bool IsWhite(const float* Pixel)
{
	return std::all_of(Pixel, Pixel + 3, [](float Value) { return Value >= 1.0f; });
}

} // namespace

FNonFiniteFootprint CountNonFinitePixels(const FRDGPass& Pass, FRDGTexture& Written)
{
	FNonFiniteFootprint Footprint{Pass.GetName(), 0, 0};
	if (!IsFloatFormat(Written.Desc.Format))
	{
		return Footprint;
	}
	FRHITexture& Texture = *Written.GetRHI();
	const FIntPoint Extent = Texture.GetSizeXY();
	const FIntRect Whole(FIntPoint(0, 0), Extent);
	FIntRect Rect = FindOutputRect(Pass).value_or(Whole);
	Rect.Clip(Whole);
	Footprint.NumPixels = static_cast<uint64_t>(Rect.Area());
	if (Footprint.NumPixels == 0)
	{
		return Footprint;
	}
	const int NumChannels = std::clamp(GPixelFormats[Texture.GetFormat()].NumComponents, 1, 4);
	const FPicture Picture(&Texture, Rect, NumChannels);
	std::vector<float> Row(static_cast<size_t>(Rect.Width()) * static_cast<size_t>(NumChannels));
	for (int Y = 0; Y < Rect.Height(); ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (auto Pixel = Row.begin(); Pixel != Row.end(); Pixel += NumChannels)
		{
			const bool bFinite =
				std::all_of(Pixel, Pixel + NumChannels, [](float Value) { return std::isfinite(Value); });
			Footprint.Pixels += bFinite ? 0 : 1;
		}
	}
	return Footprint;
}

void AddFootprint(FNonFiniteSpread& Spread, FNonFiniteFootprint Footprint)
{
	if (Footprint.GetShare() > (Spread.Passes.empty() ? 0.0 : Spread.Passes.back().GetShare()))
	{
		Spread.Passes.push_back(std::move(Footprint));
	}
}

FNonFiniteFinal CompareFinal(const FPicture& Final, const FPicture& WithZeros)
{
	constexpr size_t NumChannels = 4;
	FNonFiniteFinal Found;
	std::vector<float> Row(static_cast<size_t>(Final.Width) * NumChannels);
	std::vector<float> Other(Row.size());
	for (int Y = 0; Y < Final.Height; ++Y)
	{
		Final.ReadRow(Y, Row.data());
		WithZeros.ReadRow(Y, Other.data());
		for (size_t At = 0; At < Row.size(); At += NumChannels, ++Found.NumPixels)
		{
			const float* const Pixel = &Row[At];
			const bool bFinite =
				std::all_of(Pixel, Pixel + NumChannels, [](float Value) { return std::isfinite(Value); });
			Found.NotFinite += bFinite ? 0 : 1;
			Found.Changed += std::equal(Pixel, Pixel + NumChannels, &Other[At]) ? 0 : 1;
			Found.White += IsWhite(Pixel) && !IsWhite(&Other[At]) ? 1 : 0;
		}
	}
	return Found;
}

FDiagnostic DescribeSpread(const FNonFiniteSpread& Spread, const std::vector<FNonFiniteChannel>& InFile)
{
	std::string Message;
	for (const FStep& Step : FindLargestSteps(Spread))
	{
		const FNonFiniteFootprint& Pass = *Step.Pass;
		Message += fmt::format("{} {} of {}", Message.empty() ? "NaN and infinities spread to" : ",",
			FormatShare(Pass.Pixels, Pass.NumPixels), Pass.Pass);
	}
	if (Message.empty())
	{
		Message = "no pass spreads NaN and infinities over more than a thousandth of its pixels";
	}
	if (Spread.Final)
	{
		const FNonFiniteFinal& Final = *Spread.Final;
		Message += fmt::format("; because of those in the file, {} of {} pixels of the final picture ({}) differ from "
							   "a run with r.Drydock.NonFinite 1, {} ({}) are white and {} not finite",
			Final.Changed, Final.NumPixels, FormatShare(Final.Changed, Final.NumPixels), Final.White,
			FormatShare(Final.White, Final.NumPixels), Final.NotFinite);
	}
	const std::string Where = JoinText(InFile, ", ", &FNonFiniteChannel::Where);
	return {.Severity = ESeverity::Warning,
		.Code = WarnNonFiniteSpread,
		.Message = std::move(Message),
		.Where = std::move(Where)};
}

FNonFiniteCount CountNonFinite(const FPicture& Picture)
{
	constexpr int32 Rows = 32; // of a tile
	const int32 NumRows = Picture.MayHoldNonFinite() ? Picture.Height : 0;
	std::vector<FNonFiniteCount> Counts(static_cast<size_t>((NumRows + Rows - 1) / Rows));
	ForEachTile(FKernelTile{0, 0, 0, 1, NumRows, 1}, FIntPoint(1, Rows),
		[&](const FKernelTile& Tile)
		{
			FNonFiniteCount& Found = Counts[static_cast<size_t>(Tile.MinY / Rows)];
			std::vector<float> Row(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.NumChannels));
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				Picture.ReadRow(Y, Row.data());
				for (size_t Index = 0; Index < Row.size(); ++Index)
				{
					if (!std::isfinite(Row[Index]))
					{
						Found.Add(static_cast<int>(Index) / Picture.NumChannels, Y);
					}
				}
			}
		});
	FNonFiniteCount All;
	for (const FNonFiniteCount& Found : Counts)
	{
		All.Add(Found);
	}
	return All;
}

FDiagnostic DescribeNonFinite(const FNonFiniteChannel& Channel, const std::string& File)
{
	const FNonFiniteCount& Found = Channel.Found;
	const bool bError = GetNonFinitePolicy() == ENonFinitePolicy::Error;
	return {.Severity = bError ? ESeverity::Error : ESeverity::Warning,
		.Code = bError ? ErrorNonFinite : WarnNonFinite,
		.Message = fmt::format("{} NaN or infinite, first at pixel ({}, {})",
			Found.Count == 1 ? "1 value is" : fmt::format("{} values are", Found.Count), Found.FirstX, Found.FirstY),
		.File = File,
		.Where = Channel.Where};
}

} // namespace Drydock
