// Finds the mips that a sample at a level of detail reads. Source: Direct3D 11.3 functional specification 7.18.
#pragma once

#include "Lanes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** The mips a level falls on: First, and where Weight is not 0 also First + 1. A level between two mips takes the
 *  nearer one unless the sampler is trilinear. NaN counts as 0. */
template<typename Real>
struct TMips
{
	int32_t First;
	Real Weight;
};

template<typename Real>
DRYDOCK_LANES_INLINE TMips<Real> SelectMips(Real Level, int32_t NumMips, const FKernelSampler& Sampler)
{
	const Real Last = Real(NumMips - 1);
	Real L = Level + Real(Sampler.MipBias);
	L = L > Real(Sampler.MinLevel) ? L : Real(Sampler.MinLevel);
	L = L < Real(Sampler.MaxLevel) ? L : Real(Sampler.MaxLevel);
	L = L > 0 ? L : Real(0);
	L = L < Last ? L : Last;
	if (Sampler.Filter != EKernelFilter::Trilinear)
	{
		return {int32_t(L + Real(0.5)), Real(0)};
	}
	if (Sampler.SampleBits == 8)
	{
		L = Real(int32_t(L * Real(256) + Real(0.5))) * Real(1.0 / 256);
	}
	const int32_t First = int32_t(L);
	return {First, L - Real(First)};
}

/** The levels that a sample at Level reads: CalculateLevelOfDetail and CalculateLevelOfDetailUnclamped. */
template<typename Real>
DRYDOCK_LANES_INLINE TVec<Real, 2> DescribeLevel(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, Real Level) requires(CUniform<Real>)
{
	const TMips<Real> Mips = SelectMips(Level, Texture.NumMips, Sampler);
	return {Real(Mips.First) + Mips.Weight, Level + Real(Sampler.MipBias)};
}
} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
