// Samples of cubes, with offsets, compared with a value, and gathers, as kernels call them:
//   MakeSamplePlace<bCube, bArray>(Coordinates, Reference, Offsets)   the last two null where there is none
//   SampleAt(Texture, Sampler, Place, Level)       four channels; Level: Real or TReal
//   CompareAt(Texture, Sampler, Place, Level)      with a reference: the share of texels for which it holds
//   GatherAt(Texture, Sampler, Place, Component)   with a reference: 1 or 0 for each of the four
#pragma once

#include "LanesResources.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Coordinates: 2 of a texture, 3 of a volume or cube, one more for the layer of an array. Offsets: one for each of
 * them but the layer. The place points at these values. */
template<bool bCube, bool bArray, typename Real, int N, int n>
DRYDOCK_LANES_INLINE TSamplePlace<Real> MakeSamplePlace(const TVec<TReal<Real, N>, n>& Coordinates,
	const std::type_identity_t<TReal<Real, N>>* Reference, const std::type_identity_t<TInt<N>>* Offsets)
{
	TSamplePlace<Real> Place;
	for (int Axis = 0; Axis < n - bArray; ++Axis)
	{
		Place.Coordinates[Axis] = LanesOf(Coordinates.E[Axis]);
		Place.Offsets[Axis] = Offsets ? LanesOf(Offsets[Axis]) : nullptr;
	}
	Place.Layer = bArray ? LanesOf(Coordinates.E[n - 1]) : nullptr;
	Place.Reference = Reference ? LanesOf(*Reference) : nullptr;
	Place.bCube = bCube;
	return Place;
}

template<int N, typename Real, typename L>
DRYDOCK_LANES_INLINE TColor<Real, N> SampleAt(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place, const L& Level)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Sample(Texture, Sampler, Place, LanesOf(Level), CUniform<L>, LanesOf(Out.E[0]));
	return Out;
}
template<int N, typename Real, typename L>
DRYDOCK_LANES_INLINE TReal<Real, N> CompareAt(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place, const L& Level)
{
	return SampleAt<N>(Texture, Sampler, Place, Level)[0];
}
template<int N, typename Real>
DRYDOCK_LANES_INLINE TColor<Real, N> GatherAt(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place, int32_t Component)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Gather(Texture, Sampler, Place, Component, LanesOf(Out.E[0]));
	return Out;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
