// Computes blurs line by line: the exact one in double, the others in float lanes. The header names their papers.
#include "Study/BlurNative.h"

#include "Math/ToInteger.h"
#include "Native/NativeLanes.h"
#include "Study/BlurLanes.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace Drydock
{

namespace
{

// Lines -------------------------------------------------------------------------------------------------------------

/** Many lines side by side: element I of line L is at Data[I * NumLines + L], so that loops over lines are vectors. */
struct FLines
{
	int Length = 0;
	int NumLines = 0;
	std::vector<double> Data;

	double* At(int Index) { return Data.data() + static_cast<size_t>(Index) * static_cast<size_t>(NumLines); }
	const double* At(int Index) const
	{
		return Data.data() + static_cast<size_t>(Index) * static_cast<size_t>(NumLines);
	}
};

/** Lines to lines of the same length. */
using FLineFilter = TFunctionRef<void(const FLines& In, FLines& Out)>;

constexpr int LinesPerTile = 48;

/** Filters along one axis, in tiles of lines. */
void FilterAxis(const FImage& In, FImage& Out, bool bRows, FLineFilter Filter)
{
	const int Length = bRows ? In.Width : In.Height;
	const int NumAcross = bRows ? In.Height : In.Width;
	const int LinesAcross = std::max(1, LinesPerTile / In.NumChannels);
	const auto IndexOf = [&](int Along, int Across)
	{
		const size_t X = static_cast<size_t>(bRows ? Along : Across);
		const size_t Y = static_cast<size_t>(bRows ? Across : Along);
		return (Y * static_cast<size_t>(In.Width) + X) * static_cast<size_t>(In.NumChannels);
	};
	ForEachTile(FKernelTile{0, 0, 0, NumAcross, 1, 1}, FIntPoint(LinesAcross, 1),
		[&](const FKernelTile& Tile)
		{
			FLines Lines;
			Lines.Length = Length;
			Lines.NumLines = (Tile.MaxX - Tile.MinX) * In.NumChannels;
			Lines.Data.resize(static_cast<size_t>(Length) * static_cast<size_t>(Lines.NumLines));
			for (int Along = 0; Along < Length; ++Along)
			{
				double* Line = Lines.At(Along);
				for (int Across = Tile.MinX; Across < Tile.MaxX; ++Across)
				{
					const double* Texel = In.Values.data() + IndexOf(Along, Across);
					Line = std::copy(Texel, Texel + In.NumChannels, Line);
				}
			}
			FLines Filtered = Lines;
			Filter(Lines, Filtered);
			for (int Along = 0; Along < Length; ++Along)
			{
				const double* Line = Filtered.At(Along);
				for (int Across = Tile.MinX; Across < Tile.MaxX; ++Across)
				{
					std::copy(Line, Line + In.NumChannels, Out.Values.data() + IndexOf(Along, Across));
					Line += In.NumChannels;
				}
			}
		});
}

FImage FilterBoth(const FImage& Image, FLineFilter Filter)
{
	FImage Rows = Image;
	FImage Result = Image;
	FilterAxis(Image, Rows, true, Filter);
	FilterAxis(Rows, Result, false, Filter);
	return Result;
}

// Exact -------------------------------------------------------------------------------------------------------------

constexpr int LargestReach = 1 << 20; // of a standard deviation far beyond the 1000 that a study takes

int GetExactReach(double Sigma)
{
	// exp(-x^2 / 2 s^2) is 2^-60 at 9.12 s.
	return ToCount(std::ceil(9.2 * Sigma), 0, LargestReach) + 1;
}

/** Weights at distance 0, 1, ...: with their mirror they sum to 1. */
std::vector<double> MakeGaussian(double Sigma)
{
	std::vector<double> Weights(static_cast<size_t>(GetExactReach(Sigma)) + 1);
	double Sum = 0.0;
	for (size_t Distance = Weights.size(); Distance-- > 0;) // small ones first
	{
		const double Ratio = static_cast<double>(Distance) / Sigma;
		Weights[Distance] = std::exp(-0.5 * Ratio * Ratio);
		Sum += Weights[Distance] * (Distance == 0 ? 1.0 : 2.0);
	}
	for (double& Weight : Weights)
	{
		Weight /= Sum;
	}
	return Weights;
}

/** Tails[d]: of all weights from distance d on. */
void Convolve(const FLines& In, FLines& Out, const std::vector<double>& Weights, const std::vector<double>& Tails)
{
	const int Reach = static_cast<int>(Weights.size()) - 1;
	const auto Add = [&](double* Sum, const double* Texel, double Weight)
	{
		for (int Line = 0; Line < In.NumLines; ++Line)
		{
			Sum[Line] += Weight * Texel[Line];
		}
	};
	const auto Tail = [&](int Distance)
	{
		return Distance <= Reach ? Tails[static_cast<size_t>(Distance)] : 0.0;
	};
	for (int Index = 0; Index < In.Length; ++Index)
	{
		double* Sum = Out.At(Index);
		std::fill(Sum, Sum + In.NumLines, 0.0);
		Add(Sum, In.At(0), Tail(Index + 1));
		Add(Sum, In.At(In.Length - 1), Tail(In.Length - Index));
		const int First = std::max(0, Index - Reach);
		const int Last = std::min(In.Length - 1, Index + Reach);
		for (int Other = First; Other <= Last; ++Other)
		{
			Add(Sum, In.At(Other), Weights[static_cast<size_t>(std::abs(Other - Index))]);
		}
	}
}

// In lanes ----------------------------------------------------------------------------------------------------------

using FBlurOfLines = TFunctionRef<void(const FBlurLines& Lines, float* Scratch)>;

/** The calling thread's memory, kept: fresh pages for every tile would cost as much as the blur. */
float* GetScratch(size_t NumFloats)
{
	constexpr size_t Alignment = 64;
	static thread_local std::vector<float> Memory;
	Memory.resize(std::max(Memory.size(), NumFloats + Alignment / sizeof(float)));
	void* Begin = Memory.data();
	size_t Space = Memory.size() * sizeof(float);
	return static_cast<float*>(std::align(Alignment, NumFloats * sizeof(float), Begin, Space));
}

/** Rows, then columns, in tiles of as many lines as there are lanes. */
void BlurAxes(FFloatImage& Image, int32 LinesAtOnce, FBlurOfLines Blur)
{
	const size_t RowStep = static_cast<size_t>(Image.Width) * 4;
	for (const bool bRows : {true, false})
	{
		const int32 NumLines = bRows ? Image.Height : Image.Width;
		ForEachTile(
			FKernelTile{0, 0, 0, NumLines, 1, 1}, FIntPoint(LinesAtOnce, 1),
			[&](const FKernelTile& Tile)
			{
				FBlurLines Lines;
				Lines.TexelStep = bRows ? 4 : RowStep;
				Lines.LineStep = bRows ? RowStep : 4;
				Lines.Data = Image.Values.data() + static_cast<size_t>(Tile.MinX) * Lines.LineStep;
				Lines.Length = bRows ? Image.Width : Image.Height;
				Lines.NumLines = Tile.MaxX - Tile.MinX;
				Blur(Lines, GetScratch(GetBlurScratchFloats(Lines.Length)));
			},
			EDenormals::Flush);
	}
}

/** r whole texels to each side and the next ones by a fraction a have the variance
 * (r (r + 1) (2 r + 1) / 3 + 2 a (r + 1)^2) / (2 r + 1 + 2 a). */
FBlurBox MakeBox(double Variance)
{
	FBlurBox Box;
	while (Box.Radius < LargestReach && (Box.Radius + 1.0) * (Box.Radius + 2.0) / 3.0 <= Variance)
	{
		++Box.Radius;
	}
	const double R = Box.Radius;
	const double EndWeight =
		(2.0 * R + 1.0) * (Variance - R * (R + 1.0) / 3.0) / (2.0 * ((R + 1.0) * (R + 1.0) - Variance));
	Box.EndWeight = static_cast<float>(EndWeight);
	Box.Scale = static_cast<float>(1.0 / (2.0 * R + 1.0 + 2.0 * EndWeight));
	return Box;
}

/** The filter in double, to find out what it does beyond a line's end. */
struct FRecursionState
{
	double Real = 0.0;
	double Pair = 0.0;
	double Step = 0.0;

	double Filter(const FBlurRecursion& Recursion, double X)
	{
		Real += Recursion.First * (X - Real);
		Step += Recursion.Second * (Real - Pair) - Recursion.Damping * Step;
		Pair += Step;
		return Pair;
	}
};

/** The state beyond the end is linear in the state at the end: run the filter far enough past it from three states. */
void FindTurn(FBlurRecursion& Recursion, double Sigma)
{
	std::vector<double> Beyond(static_cast<size_t>(ToCount(60.0 * Sigma, 0, LargestReach)) + 60);
	for (int Unit = 0; Unit < 3; ++Unit)
	{
		FRecursionState There{Unit == 0 ? 1.0 : 0.0, Unit == 1 ? 1.0 : 0.0, Unit == 2 ? 1.0 : 0.0};
		for (double& Value : Beyond)
		{
			Value = There.Filter(Recursion, 0.0);
		}
		FRecursionState Back;
		std::for_each(Beyond.rbegin(), Beyond.rend(), [&](double Value) { Back.Filter(Recursion, Value); });
		Recursion.Turn[0][Unit] = static_cast<float>(Back.Real);
		Recursion.Turn[1][Unit] = static_cast<float>(Back.Pair);
		Recursion.Turn[2][Unit] = static_cast<float>(Back.Step);
	}
}

/** Poles p = q / (m + q) for the three m of the paper, so 1 - p = m / (m + q), which does not cancel for wide blurs.
 * One direction's variance is the sum of q (q + m) / m^2, so both give 2 (q^2 Re sum 1/m^2 + q Re sum 1/m): the wanted
 * variance leads to q. */
FBlurRecursion MakeRecursion(double Sigma)
{
	constexpr double Real = 1.16680;
	constexpr std::complex<double> Pair(1.10783, 1.40586);
	const double A = 1.0 / (Real * Real) + 2.0 * (1.0 / (Pair * Pair)).real();
	const double Half = (1.0 / Real + 2.0 * (1.0 / Pair).real()) / 2.0;
	const double Q = (std::sqrt(Half * Half + A * Sigma * Sigma / 2.0) - Half) / A;
	FBlurRecursion Recursion;
	Recursion.First = static_cast<float>(Real / (Real + Q));
	Recursion.Second = static_cast<float>(std::norm(Pair / (Pair + Q)));
	// 1 - |p|^2 is (|m + q|^2 - q^2) / |m + q|^2.
	Recursion.Damping = static_cast<float>((std::norm(Pair) + 2.0 * Q * Pair.real()) / std::norm(Pair + Q));
	FindTurn(Recursion, Sigma);
	return Recursion;
}

} // namespace

FImage BlurExact(const FImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return Image;
	}
	const std::vector<double> Weights = MakeGaussian(StandardDeviation);
	std::vector<double> Tails(Weights.size());
	double Sum = 0.0;
	for (size_t Distance = Weights.size(); Distance-- > 0;)
	{
		Sum += Weights[Distance];
		Tails[Distance] = Sum;
	}
	return FilterBoth(Image, [&](const FLines& In, FLines& Out) { Convolve(In, Out, Weights, Tails); });
}

FFloatImage ToFloatImage(const FImage& Image)
{
	check(Image.NumChannels == 4);
	FFloatImage Result{Image.Width, Image.Height, {}};
	Result.Values.reserve(Image.Values.size());
	for (const double Value : Image.Values)
	{
		Result.Values.push_back(static_cast<float>(Value));
	}
	return Result;
}

FImage ToImage(const FFloatImage& Image)
{
	return {Image.Width, Image.Height, 4, std::vector<double>(Image.Values.begin(), Image.Values.end())};
}

void BlurBoxes(FFloatImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return;
	}
	const FBlurBox Box = MakeBox(StandardDeviation * StandardDeviation / 3.0);
	WithNativeLanes<TBlurLanes>(
		[&](auto Lanes)
		{
			BlurAxes(Image, Lanes.NumLines,
				[&](const FBlurLines& Lines, float* Scratch) { Lanes.AverageThrice(Lines, Box, Scratch); });
		});
}

void BlurRecursive(FFloatImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return;
	}
	const FBlurRecursion Recursion = MakeRecursion(std::max(StandardDeviation, 0.5));
	WithNativeLanes<TBlurLanes>(
		[&](auto Lanes)
		{
			BlurAxes(Image, Lanes.NumLines,
				[&](const FBlurLines& Lines, float* Scratch) { Lanes.Recurse(Lines, Recursion, Scratch); });
		});
}

FNativeBlurCost GetExactCost(double StandardDeviation)
{
	return {2.0 * (2.0 * GetExactReach(StandardDeviation) + 1.0), 4.0};
}

FNativeBlurCost GetBoxesCost()
{
	// Four values enter each of three averages, along two axes; all three run while a line is at hand.
	return {24.0, 4.0};
}

FNativeBlurCost GetRecursiveCost()
{
	// One value and three earlier results, forth and back, along two axes; both directions run while a line is at hand.
	return {16.0, 4.0};
}

} // namespace Drydock
