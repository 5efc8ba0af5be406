// Finds the texels of a sample in double.
#include "Footprint.h"

#include "LanesFootprints.inl"
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
	return Mode == EKernelAddress::Wrap     ? Modulo(Size)
		   : Mode == EKernelAddress::Mirror ? std::min(Modulo(2 * Size), 2 * Size - 1 - Modulo(2 * Size))
		   : Mode == EKernelAddress::Clamp  ? std::clamp(X, 0, Size - 1)
		   : X < 0 || X >= Size             ? -1
											: X;
}

struct FPairOfTexels
{
	int32_t Index[2] = {};
	double Weight[2] = {1, 0};
};

/** Coordinates are float, or double where the shader's arithmetic is: both come as double and are snapped alike. */
FPairOfTexels FindPair(
	double Coordinate, int32_t Offset, int32_t Size, EKernelAddress Mode, const FKernelSampler& Sampler)
{
	constexpr double Far = 1 << 22;
	double X = Coordinate * Size + Offset;
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

/** The nearest layer of those that there are. */
int32_t FindLayer(double Layer, int32_t NumLayers)
{
	return std::isnan(Layer) ? 0 : int32_t(std::clamp(std::nearbyint(Layer), 0.0, double(NumLayers - 1)));
}

/** All four texels of a cube's footprint; one that lies beyond a corner is a third of each of the others. */
void AddCubeTexels(const FKernelTexture& Texture, const FKernelSampler& Sampler, const FFootprintPlace& Place,
	int32_t MipIndex, double Weight, bool bGather, FWeights& Weights)
{
	Lanes::TSamplePlace<double> At;
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		At.Coordinates[Axis] = &Place.At[Axis];
	}
	At.Layer = &Place.Layer;
	At.bCube = true;
	Lanes::TFourTexels<double, 1> Four;
	const bool bPoint = Sampler.Filter == EKernelFilter::Point && !bGather;
	Lanes::FindTexels<double, 1>(Texture.Mips[MipIndex], Sampler, At, bPoint, Four);
	for (int k = 0; k < 4; ++k)
	{
		const double X = Four.WeightX[0];
		const double Y = Four.WeightY[0];
		const double Part = bGather ? 1 : Weight * (k & 1 ? X : 1 - X) * (k >> 1 ? Y : 1 - Y);
		for (int Other = 0; Other < 4 && Part != 0; ++Other)
		{
			const bool bMissing = Four.bMissing[k][0];
			if (bMissing ? Other != k : Other == k)
			{
				Weights[{MipIndex, Four.Z[Other][0], Four.Y[Other][0], Four.X[Other][0]}] += bMissing ? Part / 3 : Part;
			}
		}
	}
}

} // namespace

std::vector<FFootprintTexel> FindGathered(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FFootprintPlace& Place)
{
	FWeights Weights;
	if (Texture.NumMips < 1)
	{
		return {};
	}
	if (Place.bCube)
	{
		AddCubeTexels(Texture, Sampler, Place, 0, 1, true, Weights);
		return ReadTexels(Texture, Sampler, Weights);
	}
	FKernelSampler Linear = Sampler;
	Linear.Filter = EKernelFilter::Bilinear;
	const FKernelMip& Mip = Texture.Mips[0];
	const FPairOfTexels X = FindPair(Place.At[0], Place.Offset[0], Mip.SizeX, Linear.AddressU, Linear);
	const FPairOfTexels Y = FindPair(Place.At[1], Place.Offset[1], Mip.SizeY, Linear.AddressV, Linear);
	const int32_t Layer = FindLayer(Place.Layer, Mip.SizeZ);
	for (int Corner = 0; Corner < 4; ++Corner)
	{
		const int32_t x = X.Index[Corner & 1];
		const int32_t y = Y.Index[Corner >> 1];
		Weights[(x | y) < 0 ? std::tuple(0, -1, -1, -1) : std::tuple(0, Layer, y, x)] += 1;
	}
	return ReadTexels(Texture, Sampler, Weights);
}

std::vector<FFootprintTexel> FindFootprint(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FFootprintPlace& Place)
{
	FWeights Weights;
	if (Texture.NumMips < 1)
	{
		return {};
	}
	double Lod = std::clamp(Place.Level + Sampler.MipBias, double(Sampler.MinLevel), double(Sampler.MaxLevel));
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
		if (Place.bCube)
		{
			AddCubeTexels(Texture, Sampler, Place, Mips[Which], MipWeights[Which], false, Weights);
			continue;
		}
		const FKernelMip& Mip = Texture.Mips[Mips[Which]];
		const FPairOfTexels X = FindPair(Place.At[0], Place.Offset[0], Mip.SizeX, Sampler.AddressU, Sampler);
		const FPairOfTexels Y = FindPair(Place.At[1], Place.Offset[1], Mip.SizeY, Sampler.AddressV, Sampler);
		FPairOfTexels Z;
		Z.Index[0] = FindLayer(Place.Layer, Mip.SizeZ);
		if (Texture.bIs3D)
		{
			Z = FindPair(Place.At[2], Place.Offset[2], Mip.SizeZ, Sampler.AddressW, Sampler);
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
