// Computes blurs line by line in double. The header names their papers.
#include "Study/BlurNative.h"

#include "Math/ToInteger.h"
#include "TileExecutor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
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

// Boxes -------------------------------------------------------------------------------------------------------------

struct FExtendedBox
{
	int Radius = 0;
	double EndWeight = 0.0; // of the texels at Radius + 1; 0..1
};

/** r whole texels to each side and the next ones by a fraction a have the variance
 * (r (r + 1) (2 r + 1) / 3 + 2 a (r + 1)^2) / (2 r + 1 + 2 a). */
FExtendedBox MakeBox(double Variance)
{
	FExtendedBox Box;
	while ((Box.Radius + 1.0) * (Box.Radius + 2.0) / 3.0 <= Variance)
	{
		++Box.Radius;
	}
	const double R = Box.Radius;
	Box.EndWeight = (2.0 * R + 1.0) * (Variance - R * (R + 1.0) / 3.0) / (2.0 * ((R + 1.0) * (R + 1.0) - Variance));
	return Box;
}

void AverageOnce(const FLines& In, FLines& Out, const FExtendedBox& Box)
{
	const auto Texel = [&](int Index)
	{
		return In.At(std::clamp(Index, 0, In.Length - 1));
	};
	const double Scale = 1.0 / (2.0 * Box.Radius + 1.0 + 2.0 * Box.EndWeight);
	std::vector<double> Window(static_cast<size_t>(In.NumLines), 0.0);
	for (int Index = -Box.Radius; Index <= Box.Radius; ++Index)
	{
		const double* Values = Texel(Index);
		for (size_t Line = 0; Line < Window.size(); ++Line)
		{
			Window[Line] += Values[Line];
		}
	}
	for (int Index = 0; Index < In.Length; ++Index)
	{
		const double* Before = Texel(Index - Box.Radius - 1);
		const double* Leaving = Texel(Index - Box.Radius);
		const double* After = Texel(Index + Box.Radius + 1);
		double* Result = Out.At(Index);
		for (size_t Line = 0; Line < Window.size(); ++Line)
		{
			Result[Line] = (Window[Line] + Box.EndWeight * (Before[Line] + After[Line])) * Scale;
			Window[Line] += After[Line] - Leaving[Line];
		}
	}
}

// Recursive ---------------------------------------------------------------------------------------------------------

/** y[n] = Gain x[n] + B1 y[n-1] + B2 y[n-2] + B3 y[n-3], then the same backwards. */
struct FRecursion
{
	double Gain = 1.0;
	std::array<double, 3> B = {};
	/** State of the backward pass beyond the end, from that of the forward pass at the end, both as differences from
	 * the constant that lies there. */
	std::array<std::array<double, 3>, 3> Turn = {};
};

/** The state beyond the end is linear in the state at the end: run the filter far enough past it from three states. */
void FindTurn(FRecursion& Filter, double Sigma)
{
	const size_t Steps = static_cast<size_t>(ToCount(60.0 * Sigma, 0, LargestReach)) + 60;
	for (size_t Unit = 0; Unit < 3; ++Unit)
	{
		std::vector<double> Forward(Steps + 3, 0.0); // [2] is the last texel of the line
		Forward[2 - Unit] = 1.0;
		for (size_t Index = 3; Index < Forward.size(); ++Index)
		{
			Forward[Index] =
				Filter.B[0] * Forward[Index - 1] + Filter.B[1] * Forward[Index - 2] + Filter.B[2] * Forward[Index - 3];
		}
		std::vector<double> Backward(Forward.size() + 3, 0.0);
		for (size_t Index = Forward.size(); Index-- > 3;)
		{
			Backward[Index] = Filter.Gain * Forward[Index] + Filter.B[0] * Backward[Index + 1] +
							  Filter.B[1] * Backward[Index + 2] + Filter.B[2] * Backward[Index + 3];
		}
		for (size_t Beyond = 0; Beyond < 3; ++Beyond)
		{
			Filter.Turn[Beyond][Unit] = Backward[3 + Beyond];
		}
	}
}

/** Poles p = q / (m + q) for the three m of the paper. One direction's variance is the sum of q (q + m) / m^2, so both
 * give 2 (q^2 Re sum 1/m^2 + q Re sum 1/m): the wanted variance leads to q. */
FRecursion MakeRecursion(double Sigma)
{
	const std::complex<double> M[3] = {{1.16680, 0.0}, {1.10783, 1.40586}, {1.10783, -1.40586}};
	std::complex<double> InverseSum = 0.0;
	std::complex<double> InverseSquareSum = 0.0;
	for (const std::complex<double>& Root : M)
	{
		InverseSum += 1.0 / Root;
		InverseSquareSum += 1.0 / (Root * Root);
	}
	const double A = InverseSquareSum.real();
	const double Half = InverseSum.real() / 2.0;
	const double Q = (std::sqrt(Half * Half + A * Sigma * Sigma / 2.0) - Half) / A;
	const std::complex<double> P[3] = {Q / (M[0] + Q), Q / (M[1] + Q), Q / (M[2] + Q)};
	FRecursion Filter;
	Filter.B[0] = (P[0] + P[1] + P[2]).real();
	Filter.B[1] = -(P[0] * P[1] + P[0] * P[2] + P[1] * P[2]).real();
	Filter.B[2] = (P[0] * P[1] * P[2]).real();
	// As a product, not as 1 - B1 - B2 - B3, which cancels for wide blurs.
	Filter.Gain = ((1.0 - P[0]) * (1.0 - P[1]) * (1.0 - P[2])).real();
	FindTurn(Filter, Sigma);
	return Filter;
}

void RecurseStep(const FRecursion& Filter, int NumLines, double* Result, const double* Input, const double* Y1,
	const double* Y2, const double* Y3)
{
	for (int Line = 0; Line < NumLines; ++Line)
	{
		Result[Line] =
			Filter.Gain * Input[Line] + Filter.B[0] * Y1[Line] + Filter.B[1] * Y2[Line] + Filter.B[2] * Y3[Line];
	}
}

/** In differences from the first texel, so that what lies before the line is zero. */
void Recurse(const FLines& In, FLines& Out, const FRecursion& Filter)
{
	const int NumLines = In.NumLines;
	const double* First = In.At(0);
	const double* Last = In.At(In.Length - 1);
	const std::vector<double> Zero(static_cast<size_t>(NumLines), 0.0);
	FLines Forward = In;
	for (int Index = 0; Index < In.Length; ++Index)
	{
		double* Texel = Forward.At(Index);
		for (int Line = 0; Line < NumLines; ++Line)
		{
			Texel[Line] -= First[Line];
		}
		const auto Earlier = [&](int Back) -> const double*
		{
			return Index >= Back ? Forward.At(Index - Back) : Zero.data();
		};
		RecurseStep(Filter, NumLines, Texel, Texel, Earlier(1), Earlier(2), Earlier(3));
	}
	std::array<std::vector<double>, 3> Beyond;
	for (size_t Place = 0; Place < Beyond.size(); ++Place)
	{
		Beyond[Place].assign(static_cast<size_t>(NumLines), 0.0);
		for (int Line = 0; Line < NumLines; ++Line)
		{
			double& State = Beyond[Place][static_cast<size_t>(Line)];
			State = Last[Line] - First[Line];
			for (int Unit = 0; Unit < 3; ++Unit)
			{
				const double AtEnd = Unit < In.Length ? Forward.At(In.Length - 1 - Unit)[Line] : 0.0;
				State += Filter.Turn[Place][static_cast<size_t>(Unit)] * (AtEnd + First[Line] - Last[Line]);
			}
		}
	}
	for (int Index = In.Length; Index-- > 0;)
	{
		const auto Later = [&](int Ahead) -> const double*
		{
			return Index + Ahead < In.Length ? Out.At(Index + Ahead)
											 : Beyond[static_cast<size_t>(Index + Ahead - In.Length)].data();
		};
		RecurseStep(Filter, NumLines, Out.At(Index), Forward.At(Index), Later(1), Later(2), Later(3));
	}
	for (int Index = 0; Index < In.Length; ++Index)
	{
		double* Texel = Out.At(Index);
		for (int Line = 0; Line < NumLines; ++Line)
		{
			Texel[Line] += First[Line];
		}
	}
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

FImage BlurBoxes(const FImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return Image;
	}
	const FExtendedBox Box = MakeBox(StandardDeviation * StandardDeviation / 3.0);
	return FilterBoth(Image,
		[&](const FLines& In, FLines& Out)
		{
			FLines Middle = In;
			AverageOnce(In, Out, Box);
			AverageOnce(Out, Middle, Box);
			AverageOnce(Middle, Out, Box);
		});
}

FImage BlurRecursive(const FImage& Image, double StandardDeviation)
{
	if (!(StandardDeviation > 0.0) || Image.Values.empty())
	{
		return Image;
	}
	const double Sigma = std::max(StandardDeviation, 0.5);
	const FRecursion Filter = MakeRecursion(Sigma);
	return FilterBoth(Image, [&](const FLines& In, FLines& Out) { Recurse(In, Out, Filter); });
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
