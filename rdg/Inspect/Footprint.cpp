// Finds the texels of a sample in double.
#include "Footprint.h"

#include "PixelFormatConversion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace Drydock
{

namespace
{

/** Texel that an index stands for; -1: the border. */
int32_t Address(int32_t X, int32_t Size, EKernelAddress Mode)
{
	const auto Modulo = [X](int32_t Period)
	{
		return (X % Period + Period) % Period;
	};
	switch (Mode)
	{
	case EKernelAddress::Wrap:
		return Modulo(Size);
	case EKernelAddress::Mirror:
		return std::min(Modulo(2 * Size), 2 * Size - 1 - Modulo(2 * Size));
	case EKernelAddress::Clamp:
		return std::clamp(X, 0, Size - 1);
	default:
		return X < 0 || X >= Size ? -1 : X;
	}
}

struct FPairOfTexels
{
	int32_t Index[2] = {};
	double Weight[2] = {1, 0};
};

/** Coordinates are float, or double where the shader's arithmetic is: both come as double and are snapped alike. */
FPairOfTexels FindPair(double Coordinate, int32_t Size, EKernelAddress Mode, const FKernelSampler& Sampler)
{
	constexpr double Far = 1 << 22;
	double X = Coordinate * Size;
	X = std::isnan(X) ? 0 : std::clamp(X, -Far, Far);
	if (Sampler.SampleBits == 8)
	{
		X = std::floor(X * 256 + 0.5) / 256;
	}
	FPairOfTexels Pair;
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	const double Shifted = bPoint ? X : X - 0.5;
	const int32_t First = int32_t(std::floor(Shifted));
	Pair.Weight[1] = bPoint ? 0 : Shifted - First;
	Pair.Weight[0] = 1 - Pair.Weight[1];
	Pair.Index[0] = Address(First, Size, Mode);
	Pair.Index[1] = Address(First + 1, Size, Mode);
	return Pair;
}

/** By mip, Z, Y, X; the border is -1, -1, -1. */
using FWeights = std::map<std::tuple<int32_t, int32_t, int32_t, int32_t>, double>;

std::vector<FFootprintTexel> ReadTexels(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FWeights& Weights)
{
	std::vector<FFootprintTexel> Texels;
	for (const auto& [At, Weight] : Weights)
	{
		FFootprintTexel& Texel = Texels.emplace_back();
		std::tie(Texel.Mip, Texel.Z, Texel.Y, Texel.X) = At;
		Texel.Weight = Weight;
		if (Texel.X < 0)
		{
			std::copy_n(Sampler.Border, 4, Texel.Value);
			continue;
		}
		const FKernelMip& Mip = Texture.Mips[Texel.Mip];
		const uint8_t* const Address = Mip.Data + Texel.Z * Mip.SlicePitch + int64_t(Texel.Y) * Mip.RowPitch +
									   int64_t(Texel.X) * GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
		DecodeTexel(Texture.Storage, Address, Texel.Value);
	}
	return Texels;
}

} // namespace

std::vector<FFootprintTexel> FindGathered(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, double U, double V)
{
	FWeights Weights;
	if (Texture.NumMips < 1)
	{
		return {};
	}
	FKernelSampler Linear = Sampler;
	Linear.Filter = EKernelFilter::Bilinear;
	const FPairOfTexels X = FindPair(U, Texture.Mips[0].SizeX, Linear.AddressU, Linear);
	const FPairOfTexels Y = FindPair(V, Texture.Mips[0].SizeY, Linear.AddressV, Linear);
	for (int Corner = 0; Corner < 4; ++Corner)
	{
		const int32_t x = X.Index[Corner & 1];
		const int32_t y = Y.Index[Corner >> 1];
		Weights[(x | y) < 0 ? std::tuple(0, -1, -1, -1) : std::tuple(0, 0, y, x)] += 1;
	}
	return ReadTexels(Texture, Sampler, Weights);
}

std::vector<FFootprintTexel> FindFootprint(const FKernelTexture& Texture, const FKernelSampler& Sampler, double U,
	double V, double W, double Level, bool bArray)
{
	FWeights Weights;
	if (Texture.NumMips < 1)
	{
		return {};
	}
	double Lod = Level + Sampler.MipBias;
	Lod = Lod > 0 ? std::min(Lod, double(Texture.NumMips - 1)) : 0;
	const bool bTrilinear = Sampler.Filter == EKernelFilter::Trilinear;
	const int32_t Mips[2] = {int32_t(std::floor(bTrilinear ? Lod : Lod + 0.5)), int32_t(std::floor(Lod)) + 1};
	const double MipWeights[2] = {bTrilinear ? 1 - (Lod - std::floor(Lod)) : 1, bTrilinear ? Lod - std::floor(Lod) : 0};
	for (int Which = 0; Which < 2; ++Which)
	{
		if (MipWeights[Which] == 0 || Mips[Which] >= Texture.NumMips)
		{
			continue;
		}
		const FKernelMip& Mip = Texture.Mips[Mips[Which]];
		const FPairOfTexels X = FindPair(U, Mip.SizeX, Sampler.AddressU, Sampler);
		const FPairOfTexels Y = FindPair(V, Mip.SizeY, Sampler.AddressV, Sampler);
		FPairOfTexels Z;
		if (Texture.bIs3D)
		{
			Z = FindPair(W, Mip.SizeZ, Sampler.AddressW, Sampler);
		}
		else if (bArray)
		{
			Z.Index[0] = std::isnan(W) ? 0 : int32_t(std::clamp(std::nearbyint(W), 0.0, double(Mip.SizeZ - 1)));
		}
		for (int Corner = 0; Corner < 8; ++Corner)
		{
			const int x = Corner & 1;
			const int y = Corner >> 1 & 1;
			const int z = Corner >> 2;
			const double Weight = MipWeights[Which] * X.Weight[x] * Y.Weight[y] * Z.Weight[z];
			if (Weight != 0)
			{
				const bool bBorder = (X.Index[x] | Y.Index[y] | Z.Index[z]) < 0;
				Weights[bBorder ? std::tuple(Mips[Which], -1, -1, -1)
								: std::tuple(Mips[Which], Z.Index[z], Y.Index[y], X.Index[x])] += Weight;
			}
		}
	}
	return ReadTexels(Texture, Sampler, Weights);
}

} // namespace Drydock
