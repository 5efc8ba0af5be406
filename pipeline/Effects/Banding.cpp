// Counts levels, steps and flat runs of a stored gradient.
#include "Effects/Banding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

namespace Drydock
{

namespace
{

struct FRange
{
	double Least = 0.0;
	double Greatest = 0.0;
};

FRange FindRange(const FImage& Image, int Channel)
{
	FRange Range{HUGE_VAL, -HUGE_VAL};
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			const double Value = Image.Get(X, Y, Channel);
			Range.Least = std::min(Range.Least, std::isnan(Value) ? HUGE_VAL : Value);
			Range.Greatest = std::max(Range.Greatest, std::isnan(Value) ? -HUGE_VAL : Value);
		}
	}
	return Range;
}

/** The longest run of one value inside the range, among Count values. */
int FindLongestRun(int Count, const FRange& Range, const std::function<double(int)>& Value)
{
	int Longest = 0, Run = 0;
	for (int Index = 0; Index < Count; ++Index)
	{
		const double Here = Value(Index);
		const bool bInside = Here > Range.Least && Here < Range.Greatest;
		Run = !bInside ? 0 : Index > 0 && Value(Index - 1) == Here ? Run + 1 : 1;
		Longest = std::max(Longest, Run);
	}
	return Longest;
}

size_t FindStepBin(double Step)
{
	const auto Bound = std::lower_bound(BandingStepBounds.begin(), BandingStepBounds.end(), Step);
	return static_cast<size_t>(Bound - BandingStepBounds.begin());
}

} // namespace

FBandingFigures MeasureBanding(const FImage& Image, int Channel)
{
	FBandingFigures Figures;
	const FRange Range = FindRange(Image, Channel);
	std::set<double> Levels;
	const auto Compare = [&](double A, double B)
	{
		if (!std::isnan(A) && !std::isnan(B))
		{
			++Figures.StepHistogram[FindStepBin(std::abs(A - B) * 255.0)];
		}
	};
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			const double Value = Image.Get(X, Y, Channel);
			if (!std::isnan(Value))
			{
				Levels.insert(Value);
			}
			if (X > 0)
			{
				Compare(Image.Get(X - 1, Y, Channel), Value);
			}
			if (Y > 0)
			{
				Compare(Image.Get(X, Y - 1, Channel), Value);
			}
		}
		Figures.LongestFlatRun = std::max(Figures.LongestFlatRun,
			FindLongestRun(Image.Width, Range, [&](int X) { return Image.Get(X, Y, Channel); }));
	}
	for (int X = 0; X < Image.Width; ++X)
	{
		Figures.LongestFlatRun = std::max(Figures.LongestFlatRun,
			FindLongestRun(Image.Height, Range, [&](int Y) { return Image.Get(X, Y, Channel); }));
	}
	Figures.UniqueLevels = Levels.size();
	Figures.DarkLevels = static_cast<uint64_t>(std::distance(Levels.begin(), Levels.lower_bound(DarkBelow)));
	return Figures;
}

FDarkDeviation MeasureDarkDeviation(const FImage& Stored, const FImage& Exact, int Channel)
{
	FDarkDeviation Deviation;
	double Sum = 0.0;
	for (int Y = 0; Y < Exact.Height; ++Y)
	{
		for (int X = 0; X < Exact.Width; ++X)
		{
			const double Value = Exact.Get(X, Y, Channel);
			if (!(Value > 0.0 && Value < DarkBelow))
			{
				continue;
			}
			const double Error = std::abs(Stored.Get(X, Y, Channel) - Value) * 255.0;
			Sum += Error * Error;
			Deviation.Largest = std::max(Deviation.Largest, Error);
			++Deviation.Texels;
		}
	}
	Deviation.Rms = Deviation.Texels > 0 ? std::sqrt(Sum / static_cast<double>(Deviation.Texels)) : 0.0;
	return Deviation;
}

FImage MakeBandingMap(const FImage& Image, int Channel)
{
	const FRange Range = FindRange(Image, Channel);
	const double Scale = Range.Greatest > Range.Least ? 1.0 / (Range.Greatest - Range.Least) : 0.0;
	FImage Map{Image.Width, Image.Height, 3, {}};
	Map.Values.reserve(static_cast<size_t>(Image.Width) * static_cast<size_t>(Image.Height) * 3);
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			const double Value = Image.Get(X, Y, Channel);
			const bool bStep =
				(X > 0 && Image.Get(X - 1, Y, Channel) != Value) || (Y > 0 && Image.Get(X, Y - 1, Channel) != Value);
			const bool bInside = Value > Range.Least && Value < Range.Greatest;
			const double Grey = std::isnan(Value) ? 0.0 : 0.6 * (Value - Range.Least) * Scale;
			Map.Values.push_back(bStep ? 1.0 : Grey);
			Map.Values.push_back(!bStep && bInside ? 0.3 + Grey : Grey);
			Map.Values.push_back(Grey);
		}
	}
	return Map;
}

} // namespace Drydock
