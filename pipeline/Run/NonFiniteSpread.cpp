// Counts what passes write that is not finite, and says it in a sentence.
#include <fmt/format.h>

#include "Run/NonFiniteSpread.h"

#include "Picture/TextureImage.h"
#include "RenderGraphPass.h"
#include "RenderGraphResources.h"
#include "Run/VariableTaps.h"
#include "Text/ConfigErrors.h"

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

bool IsWhite(const FImage& Image, int X, int Y)
{
	return Image.Get(X, Y, 0) >= 1.0 && Image.Get(X, Y, 1) >= 1.0 && Image.Get(X, Y, 2) >= 1.0;
}

} // namespace

FNonFiniteFootprint CountNonFinitePixels(const FRDGPass& Pass, FRDGTexture& Written)
{
	FNonFiniteFootprint Footprint{Pass.GetName(), 0, 0};
	if (!IsFloatFormat(Written.Desc.Format))
	{
		return Footprint;
	}
	const FImage Image = ReadTexture(*Written.GetRHI());
	const FIntRect Whole(0, 0, Image.Width, Image.Height);
	FIntRect Rect = FindOutputRect(Pass).value_or(Whole);
	Rect.Clip(Whole);
	Footprint.NumPixels = static_cast<uint64_t>(Rect.Area());
	for (int Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		for (int X = Rect.Min.X; X < Rect.Max.X; ++X)
		{
			bool bFinite = true;
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				bFinite = bFinite && std::isfinite(Image.Get(X, Y, Channel));
			}
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

FNonFiniteFinal CompareFinal(const FImage& Final, const FImage& WithZeros)
{
	FNonFiniteFinal Found;
	for (int Y = 0; Y < Final.Height; ++Y)
	{
		for (int X = 0; X < Final.Width; ++X, ++Found.NumPixels)
		{
			bool bFinite = true, bSame = true;
			for (int Channel = 0; Channel < Final.NumChannels; ++Channel)
			{
				const double Value = Final.Get(X, Y, Channel);
				bFinite = bFinite && std::isfinite(Value);
				bSame = bSame && Value == WithZeros.Get(X, Y, Channel);
			}
			Found.NotFinite += bFinite ? 0 : 1;
			Found.Changed += bSame ? 0 : 1;
			Found.White += IsWhite(Final, X, Y) && !IsWhite(WithZeros, X, Y) ? 1 : 0;
		}
	}
	return Found;
}

FDiagnostic DescribeSpread(const FNonFiniteSpread& Spread)
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
		Message += fmt::format("; because of the file's, {} of {} pixels of the final picture ({}) are others than "
							   "with 0 in their place (r.Drydock.NonFinite 1), {} ({}) are white and {} not finite",
			Final.Changed, Final.NumPixels, FormatShare(Final.Changed, Final.NumPixels), Final.White,
			FormatShare(Final.White, Final.NumPixels), Final.NotFinite);
	}
	return {.Severity = ESeverity::Warning,
		.Code = WarnNonFiniteSpread,
		.Message = std::move(Message),
		.Where = "scene colour"};
}

} // namespace Drydock
