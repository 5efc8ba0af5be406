// Computes the exact blur line by line, in double.
#include "Study/BlurExact.h"

#include "Math/ToInteger.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Drydock
{

namespace
{

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

constexpr int LargestReach = 1 << 20; // of a standard deviation far beyond the 1000 that a study takes

int GetExactReach(double Sigma)
{
	// exp(-x^2 / 2 s^2) is 2^-60 at 9.12 s.
	return ToCount(std::ceil(9.2 * Sigma), 0, LargestReach) + 1;
}

struct FKernelWeights
{
	std::vector<double> Weights; // at distance 0, 1, ...: with their mirror they sum to 1
	std::vector<double> Tails;   // the sums of all weights from distance 0, 1, ... on
};

FKernelWeights MakeGaussian(double Sigma)
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
	std::vector<double> Tails(Weights.size());
	double Tail = 0.0;
	for (size_t Distance = Weights.size(); Distance-- > 0;)
	{
		Tail += Weights[Distance];
		Tails[Distance] = Tail;
	}
	return {std::move(Weights), std::move(Tails)};
}

void Convolve(const FLines& In, FLines& Out, const FKernelWeights& Kernel)
{
	const auto& [Weights, Tails] = Kernel;
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

/** Blurs along one axis, in tiles of lines. */
FImage BlurAxis(const FImage& In, bool bRows, const FKernelWeights& Kernel)
{
	constexpr int LinesPerTile = 48;
	FImage Out = In;
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
			FLines Blurred = Lines;
			Convolve(Lines, Blurred, Kernel);
			for (int Along = 0; Along < Length; ++Along)
			{
				const double* Line = Blurred.At(Along);
				for (int Across = Tile.MinX; Across < Tile.MaxX; ++Across)
				{
					std::copy(Line, Line + In.NumChannels, Out.Values.data() + IndexOf(Along, Across));
					Line += In.NumChannels;
				}
			}
		});
	return Out;
}

} // namespace

FImage BlurExact(const FImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return Image;
	}
	const FKernelWeights Kernel = MakeGaussian(StandardDeviation);
	return BlurAxis(BlurAxis(Image, true, Kernel), false, Kernel);
}

double GetExactTaps(double StandardDeviation)
{
	return 2.0 * (2.0 * GetExactReach(StandardDeviation) + 1.0);
}

} // namespace Drydock
