// Which four texels a sample takes, and their weights: on a flat texture, or on the faces of a cube.
//
// Cubes. A texel beyond an edge of its face is that of the face beyond. Beyond a corner there is none: it is the
// average of the three texels that meet there. The sampler's address modes say nothing; a point sample stays on its
// face. Source: Direct3D 11 functional specification 7.18; Vulkan specification, "Cube Map Edge Handling".
#pragma once

#include "LanesCoordinates.inl"
#include "LanesLod.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A place at one mip: moved by the offsets, which are in texels of this mip. */
template<typename Real, int N>
struct TPlaceAtMip : TSamplePlace<Real>
{
	alignas(64) Real Moved[3][N];

	TPlaceAtMip(const TSamplePlace<Real>& Place, const FKernelMip& Mip)
		: TSamplePlace<Real>(Place)
	{
		const int32_t Sizes[3] = {Mip.SizeX, Mip.SizeY, Mip.SizeZ};
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			for (int Lane = 0; Lane < N && Place.Offsets[Axis]; ++Lane)
			{
				Moved[Axis][Lane] = Place.Coordinates[Axis][Lane] + Real(Place.Offsets[Axis][Lane]) / Real(Sizes[Axis]);
				this->Coordinates[Axis] = Moved[Axis];
			}
		}
	}
	TPlaceAtMip(const TPlaceAtMip&) = delete;
	TPlaceAtMip& operator=(const TPlaceAtMip&) = delete;
};

/** The four texels of a footprint: bit 0 of an index is the second column, bit 1 the second row. A column of -1 is the
 *  border. bMissing: beyond a cube's corner; the indices are then those of some other texel. */
template<typename Real, int N>
struct TFourTexels
{
	TInt<N> X[4];
	TInt<N> Y[4];
	TInt<N> Z[4];
	TMask<N> bMissing[4] = {false, false, false, false};
	TReal<Real, N> WeightX;
	TReal<Real, N> WeightY;
	bool bAnyMissing = false;
};

struct FCubeTexel
{
	int32_t X;
	int32_t Y;
	int32_t Face;
};

/** The direction along a face's columns, along its rows or out of it: an axis of the cube and its sign. */
struct FCubeAxis
{
	int32_t Axis;
	int32_t Sign;
};
constexpr FCubeAxis GCubeFaces[6][3] = {{{2, -1}, {1, -1}, {0, 1}}, {{2, 1}, {1, -1}, {0, -1}},
	{{0, 1}, {2, 1}, {1, 1}}, {{0, 1}, {2, -1}, {1, -1}}, {{0, 1}, {1, -1}, {2, 1}}, {{0, -1}, {1, -1}, {2, -1}}};

/** The texel of the face beyond the edge, for one that lies a texel outside of its own face in X or in Y. */
inline FCubeTexel FindTexelBeyond(int32_t X, int32_t Y, int32_t Face, int32_t Size)
{
	// Texels' centres around the centre of a cube that is 2 Size wide: the surface is folded down at the edge.
	int32_t At[3] = {2 * X + 1 - Size, 2 * Y + 1 - Size, Size - 1};
	const int Out = At[0] < -Size || At[0] > Size ? 0 : 1;
	At[Out] = At[Out] < 0 ? -Size : Size;
	int32_t OnCube[3];
	for (int i = 0; i < 3; ++i)
	{
		OnCube[GCubeFaces[Face][i].Axis] = GCubeFaces[Face][i].Sign * At[i];
	}
	const FCubeAxis Beyond = GCubeFaces[Face][Out];
	const int32_t Other = 2 * Beyond.Axis + (OnCube[Beyond.Axis] < 0);
	const auto Along = [&OnCube, Other, Size](int i)
	{
		const FCubeAxis Axis = GCubeFaces[Other][i];
		return (Axis.Sign * OnCube[Axis.Axis] + Size - 1) / 2;
	};
	return {Along(0), Along(1), Other};
}

template<typename Real, int N>
inline void FindCubeTexels(const FKernelMip& Mip, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
	bool bPoint, TFourTexels<Real, N>& Out)
{
	using FLanes = TReal<Real, N>;
	TVec<FLanes, 3> Direction;
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		__builtin_memcpy(&Direction.E[Axis], Place.Coordinates[Axis], sizeof(FLanes));
	}
	const TCubeFrame<FLanes> Frame(Direction);
	const TVec<FLanes, 3> At = Frame.Turn(Direction);
	const FLanes Half(Real(0.5));
	const FLanes U = Half * (At[0] / At[2]) + Half;
	const FLanes V = Half * (At[1] / At[2]) + Half;
	const int32_t Size = Mip.SizeX < Mip.SizeY ? Mip.SizeX : Mip.SizeY;
	TAxis<Real, N> X = MakeAxis<Real, N>(LanesOf(U), Size, bPoint, Sampler.SampleBits);
	TAxis<Real, N> Y = MakeAxis<Real, N>(LanesOf(V), Size, bPoint, Sampler.SampleBits);
	// A direction with a NaN may point beyond the face that was found for it.
	const TInt<N> Lowest(bPoint ? 0 : -1);
	X.First = Min(Max(X.First, Lowest), TInt<N>(Size - 1));
	Y.First = Min(Max(Y.First, Lowest), TInt<N>(Size - 1));
	Out.WeightX = X.Weight;
	Out.WeightY = Y.Weight;
	const int32_t NumCubes = Mip.SizeZ < 6 ? 1 : Mip.SizeZ / 6;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t Face = (Frame.bZ[Lane] ? 4 : Frame.bY[Lane] ? 2 : 0) + Frame.bNegative[Lane];
		const int32_t Cube = Place.Layer ? SelectLayer(Place.Layer[Lane], NumCubes) : 0;
		for (int k = 0; k < 4; ++k)
		{
			// A point sample has no second texels: they would be of weight 0.
			FCubeTexel Texel = {X.First[Lane] + (bPoint ? 0 : k & 1), Y.First[Lane] + (bPoint ? 0 : k >> 1), Face};
			const bool bOutX = uint32_t(Texel.X) >= uint32_t(Size);
			const bool bOutY = uint32_t(Texel.Y) >= uint32_t(Size);
			if (bOutX && bOutY)
			{
				Out.bMissing[k].V[Lane] = -1;
				Out.bAnyMissing = true;
				Texel = {0, 0, Face};
			}
			else if (bOutX || bOutY)
			{
				Texel = FindTexelBeyond(Texel.X, Texel.Y, Face, Size);
			}
			const int32_t Slice = Cube * 6 + Texel.Face;
			Out.X[k].V[Lane] = Texel.X;
			Out.Y[k].V[Lane] = Texel.Y;
			Out.Z[k].V[Lane] = Slice < Mip.SizeZ ? Slice : Mip.SizeZ - 1;
		}
	}
}

template<typename Real, int N>
inline void FindTexels(const FKernelMip& Mip, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
	bool bPoint, TFourTexels<Real, N>& Out)
{
	if (Place.bCube)
	{
		FindCubeTexels<Real, N>(Mip, Sampler, Place, bPoint, Out);
		return;
	}
	const TAxis<Real, N> X = MakeAxis<Real, N>(Place.Coordinates[0], Mip.SizeX, bPoint, Sampler.SampleBits);
	const TAxis<Real, N> Y = MakeAxis<Real, N>(Place.Coordinates[1], Mip.SizeY, bPoint, Sampler.SampleBits);
	TInt<N> Layers(0);
	for (int Lane = 0; Lane < N && Place.Layer; ++Lane)
	{
		Layers.V[Lane] = SelectLayer(Place.Layer[Lane], Mip.SizeZ);
	}
	for (int k = 0; k < 2; ++k)
	{
		Out.X[k] = Out.X[k + 2] = AddressTexels(X.First + TInt<N>(k), Mip.SizeX, Sampler.AddressU);
		Out.Y[2 * k] = Out.Y[2 * k + 1] = AddressTexels(Y.First + TInt<N>(k), Mip.SizeY, Sampler.AddressV);
		Out.Z[k] = Out.Z[k + 2] = Layers;
	}
	Out.WeightX = X.Weight;
	Out.WeightY = Y.Weight;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
