// Runs pixels by quads: a pack of N lanes is N / 2 columns of two rows, from an even column and row on. The four pixels
// of a quad always lie in the same four lanes. The value of a lane that does not run counts as no difference, and is
// read as 0. Included by generated code only. Source: Direct3D 11.3 functional specification 22.5.
#pragma once

#include "LanesLevels.h"
#include "LanesLod.h"

#include <utility>

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Column and row in the pack. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> PackColumn()
{
	return LaneIndex<N>() & TInt<N>(N / 2 - 1);
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> PackRow()
{
	return Select(LaneIndex<N>() < TInt<N>(N / 2), TInt<N>(0), TInt<N>(1));
}

/** The column or row that a lane itself is in. */
constexpr int GOwn = -1;

/** Gives each lane the value of its quad's pixel in a column and a row, 0 or 1 or GOwn. */
template<int Column, int Row, typename V, int... Lanes>
DRYDOCK_LANES_INLINE V TakeLanes(V Value, std::integer_sequence<int, Lanes...>)
{
	constexpr int Width = sizeof...(Lanes) / 2;
	return __builtin_shufflevector(Value, Value,
		(Column == GOwn ? Lanes % Width : Lanes % Width / 2 * 2 + Column) +
			(Row == GOwn ? Lanes / Width : Row) * Width...);
}
template<int Column, int Row, typename T>
DRYDOCK_LANES_INLINE T TakeCorner(T Value)
{
	constexpr int N = sizeof(Value.V) / sizeof(Value.V[0]);
	Value.V = TakeLanes<Column, Row>(Value.V, std::make_integer_sequence<int, N>());
	return Value;
}

template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> Difference(TMask<N> RunA, TReal<Real, N> A, TMask<N> RunB, TReal<Real, N> B)
{
	return Select(RunA & RunB, B - A, TReal<Real, N>(Real(0)));
}

/** Along x and along y: each row's and each column's own difference. */
template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> DdxFine(TMask<N> e, TReal<Real, N> V)
{
	return Difference(TakeCorner<0, GOwn>(e), TakeCorner<0, GOwn>(V), TakeCorner<1, GOwn>(e), TakeCorner<1, GOwn>(V));
}
template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> DdyFine(TMask<N> e, TReal<Real, N> V)
{
	return Difference(TakeCorner<GOwn, 0>(e), TakeCorner<GOwn, 0>(V), TakeCorner<GOwn, 1>(e), TakeCorner<GOwn, 1>(V));
}

/** One for the quad: those of its first row and of its first column. */
template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> Ddx(TMask<N> e, TReal<Real, N> V)
{
	return Difference(TakeCorner<0, 0>(e), TakeCorner<0, 0>(V), TakeCorner<1, 0>(e), TakeCorner<1, 0>(V));
}
template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> Ddy(TMask<N> e, TReal<Real, N> V)
{
	return Difference(TakeCorner<0, 0>(e), TakeCorner<0, 0>(V), TakeCorner<0, 1>(e), TakeCorner<0, 1>(V));
}

template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> FwidthFine(TMask<N> e, TReal<Real, N> V)
{
	return Abs(DdxFine(e, V)) + Abs(DdyFine(e, V));
}
template<int N, typename Real>
DRYDOCK_LANES_INLINE TReal<Real, N> Fwidth(TMask<N> e, TReal<Real, N> V)
{
	return Abs(Ddx(e, V)) + Abs(Ddy(e, V));
}

/** Value of the pixel of the same quad that Index, 0 to 3 by rows, names; of none that runs: 0. */
template<int N, CLanes T>
DRYDOCK_LANES_INLINE T ReadQuadLane(TMask<N> e, T Value, TUint<N> Index)
{
	T Result{};
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint32_t Corner = Index[Lane] & 3;
		const int From = Lane % (N / 2) / 2 * 2 + int(Corner & 1) + int(Corner >> 1) * (N / 2);
		if (e[From])
		{
			Result.V[Lane] = Value.V[From];
		}
	}
	return Result;
}
/** The other column's, the other row's, or what lies across. */
template<int N, CLanes T>
DRYDOCK_LANES_INLINE T ReadQuadAcross(TMask<N> e, T Value, bool bX, bool bY)
{
	const TUint<N> Own = AsUint((PackColumn<N>() & TInt<N>(1)) + PackRow<N>() + PackRow<N>());
	return ReadQuadLane(e, Value, Own ^ TUint<N>(uint32_t(bX) | uint32_t(bY) << 1));
}

/** Level of detail that the quad's first row and column give coordinates, or the directions of a cube. */
template<bool bCube, int N, typename Real, int Count>
DRYDOCK_LANES_INLINE TReal<Real, N> QuadLevel(
	TMask<N> e, const FKernelTexture& Texture, const TVec<TReal<Real, N>, Count>& UV)
{
	TVec<TReal<Real, N>, Count> AlongX;
	TVec<TReal<Real, N>, Count> AlongY;
	for (int i = 0; i < Count; ++i)
	{
		AlongX.E[i] = Ddx(e, UV.E[i]);
		AlongY.E[i] = Ddy(e, UV.E[i]);
	}
	if constexpr (bCube)
	{
		return GradientLevelCube(Texture, UV, AlongX, AlongY);
	}
	else
	{
		return GradientLevel(Texture, AlongX, AlongY);
	}
}
/** The same for a sample: of a view of one mip there is nothing to choose. */
template<bool bCube, int N, typename Real, int Count>
DRYDOCK_LANES_INLINE TReal<Real, N> SampleLevelOf(
	TMask<N> e, const FKernelTexture& Texture, const TVec<TReal<Real, N>, Count>& UV)
{
	return Texture.NumMips > 1 ? QuadLevel<bCube>(e, Texture, UV) : TReal<Real, N>(Real(0));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TVec<TReal<Real, N>, 2> DescribeLevel(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, TReal<Real, N> Level)
{
	TVec<TReal<Real, N>, 2> Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const TVec<Real, 2> One = DescribeLevel(Texture, Sampler, Level[Lane]);
		Result.E[0].V[Lane] = One.E[0];
		Result.E[1].V[Lane] = One.E[1];
	}
	return Result;
}

/** Pixel-shader input at the centres of the pixels (X, Y0) and (X, Y0 + 1). */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> InterpolateQuads(
	const FKernelInterpolant& Interpolant, int Component, TInt<N> X, int32_t Y0)
{
	return Select(PackRow<N>() == TInt<N>(0), Interpolate<Real>(Interpolant, Component, X, Y0),
		Interpolate<Real>(Interpolant, Component, X, Y0 + 1));
}

/** StoreTarget of a pack of quads whose first pixel is (X0, Y0). */
template<typename Real, int N, typename T>
DRYDOCK_LANES_INLINE void StoreTargetQuads(
	TMask<N> Mask, const FKernelTarget& Target, int32_t X0, int32_t Y0, T Red, T Green, T Blue, T Alpha)
{
	const TMask<N> First = PackRow<N>() == TInt<N>(0);
	StoreTarget<Real, N>(Mask & First, Target, X0, Y0, TVec<T, 4>(Red, Green, Blue, Alpha));
	// The second row's lanes come first for a store of its own.
	StoreTarget<Real, N>(TakeCorner<GOwn, 1>(Mask) & First, Target, X0, Y0 + 1,
		TVec<T, 4>(TakeCorner<GOwn, 1>(Red), TakeCorner<GOwn, 1>(Green), TakeCorner<GOwn, 1>(Blue),
			TakeCorner<GOwn, 1>(Alpha)));
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
