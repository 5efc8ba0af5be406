// Computes the exact blur along rows, then along columns, in double.
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

/** In tiles of columns, so that loops over these are vectors. */
FImage BlurColumns(const FImage& In, const FKernelWeights& Kernel)
{
	constexpr int ValuesPerTile = 48;
	const int Reach = static_cast<int>(Kernel.Weights.size()) - 1;
	const int RowLength = In.Width * In.NumChannels;
	FImage Out = In;
	const auto BlurTile = [&](const FKernelTile& Tile)
	{
		const auto GetIndex = [&](int Row)
		{
			return static_cast<size_t>(Row) * static_cast<size_t>(RowLength) + static_cast<size_t>(Tile.MinX);
		};
		for (int Row = 0; Row < In.Height; ++Row)
		{
			double* Sum = Out.Values.data() + GetIndex(Row);
			std::fill(Sum, Sum + (Tile.MaxX - Tile.MinX), 0.0);
			const auto Add = [&](int Other, double Weight)
			{
				const double* Value = In.Values.data() + GetIndex(Other);
				for (int Column = 0; Column < Tile.MaxX - Tile.MinX; ++Column)
				{
					Sum[Column] += Weight * Value[Column];
				}
			};
			const auto Tail = [&](int Distance)
			{
				return Distance <= Reach ? Kernel.Tails[static_cast<size_t>(Distance)] : 0.0;
			};
			Add(0, Tail(Row + 1));
			Add(In.Height - 1, Tail(In.Height - Row));
			const int Last = std::min(In.Height - 1, Row + Reach);
			for (int Other = std::max(0, Row - Reach); Other <= Last; ++Other)
			{
				Add(Other, Kernel.Weights[static_cast<size_t>(std::abs(Other - Row))]);
			}
		}
	};
	ForEachTile(FKernelTile{0, 0, 0, RowLength, 1, 1}, FIntPoint(ValuesPerTile, 1), BlurTile);
	return Out;
}

FImage Transpose(const FImage& In)
{
	FImage Out{In.Height, In.Width, In.NumChannels, {}};
	Out.Values.reserve(In.Values.size());
	for (int X = 0; X < In.Width; ++X)
	{
		for (int Y = 0; Y < In.Height; ++Y)
		{
			for (int Channel = 0; Channel < In.NumChannels; ++Channel)
			{
				Out.Values.push_back(In.Get(X, Y, Channel));
			}
		}
	}
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
	return BlurColumns(Transpose(BlurColumns(Transpose(Image), Kernel)), Kernel);
}

double GetExactTaps(double StandardDeviation)
{
	return 2.0 * (2.0 * GetExactReach(StandardDeviation) + 1.0);
}

} // namespace Drydock
