// From sample coordinates to texels and weights, in lanes. Direct3D's fixed point: x = uv * size is snapped to
// floor(x * 256 + 0.5) / 256, all in the arithmetic of the shader; then a point sample takes the floor and a bilinear
// one the fraction of x - 0.5, both exact. Included by the LanesSampling_*.cpp only. Source: D3D11 functional
// specification 3.2.4.1, 7.18.
#pragma once

#include "Lanes.h"
#include "LanesLevels.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** One axis of a sample: texels First and First + 1 before addressing, and the weight of the second. */
template<typename Real, int N>
struct TAxis
{
	TInt<N> First;
	TReal<Real, N> Weight;
};

/** Coordinates beyond this many texels stick there: far outside any texture, far inside int32 with its 8 extra bits. */
constexpr int32_t GFarTexel = 1 << 22;

/** From a coordinate in 1/256 texels. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TAxis<Real, N> MakeAxisFixed(TInt<N> Snapped, bool bPoint)
{
	if (bPoint)
	{
		return {TInt<N>(Snapped.V >> 8), TReal<Real, N>(Real(0))};
	}
	const TRaw<int32_t, N> Fixed = Snapped.V - 128;
	return {TInt<N>(Fixed >> 8), ToReal<Real>(TInt<N>(Fixed & 255)) * TReal<Real, N>(Real(1.0 / 256))};
}

/** NaN counts as 0. Weight is 0 for point samples. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TAxis<Real, N> MakeAxis(const Real* Coordinates, int32_t Size, bool bPoint, uint8_t SampleBits)
{
	using FLanes = TReal<Real, N>;
	FLanes X;
	__builtin_memcpy(&X, Coordinates, sizeof(X));
	X = X * FLanes(Real(Size));
	X = Select(X == X, X, FLanes(Real(0)));
	X = Select(X < FLanes(Real(GFarTexel)), X, FLanes(Real(GFarTexel)));
	X = Select(X > FLanes(Real(-GFarTexel)), X, FLanes(Real(-GFarTexel)));

	if (SampleBits == 8)
	{
		const FLanes Whole = Floor(X * FLanes(Real(256)) + FLanes(Real(0.5)));
		return MakeAxisFixed<Real, N>(TInt<N>(__builtin_convertvector(Whole.V, TRaw<int32_t, N>)), bPoint);
	}
	const FLanes Shifted = bPoint ? X : X - FLanes(Real(0.5));
	const FLanes Whole = Floor(Shifted);
	return {TInt<N>(__builtin_convertvector(Whole.V, TRaw<int32_t, N>)), bPoint ? FLanes(Real(0)) : Shifted - Whole};
}

/** Texel that an index stands for, -1 for the border. Size is at least 1. */
DRYDOCK_LANES_INLINE int32_t AddressTexel(int32_t X, int32_t Size, EKernelAddress Mode)
{
	if (uint32_t(X) < uint32_t(Size))
	{
		return X;
	}
	switch (Mode)
	{
	case EKernelAddress::Wrap:
	{
		const int32_t R = X % Size;
		return R < 0 ? R + Size : R;
	}
	case EKernelAddress::Mirror:
	{
		const int32_t Period = 2 * Size;
		int32_t R = X % Period;
		R = R < 0 ? R + Period : R;
		return R < Size ? R : Period - 1 - R;
	}
	case EKernelAddress::Clamp:
		return X < 0 ? 0 : Size - 1;
	case EKernelAddress::Border:
		break;
	}
	return -1;
}

template<int N>
DRYDOCK_LANES_INLINE TInt<N> AddressTexels(TInt<N> X, int32_t Size, EKernelAddress Mode)
{
	if (Mode == EKernelAddress::Clamp)
	{
		return Min(Max(X, TInt<N>(0)), TInt<N>(Size - 1));
	}
	if (AllLanes(ToUint(X) < TUint<N>(uint32_t(Size))))
	{
		return X;
	}
	for (int Lane = 0; Lane < N; ++Lane)
	{
		X.V[Lane] = AddressTexel(X.V[Lane], Size, Mode);
	}
	return X;
}

/** Array layer: nearest, of two as near the even one, as D3D11.3 rounds; clamped. NaN counts as 0. */
template<typename Real>
DRYDOCK_LANES_INLINE int32_t SelectLayer(Real Layer, int32_t NumLayers)
{
	const Real Last = Real(NumLayers - 1);
	Real L = Layer > 0 ? Layer : Real(0);
	L = L < Last ? L : Last;
	return int32_t(__builtin_rint(L));
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
