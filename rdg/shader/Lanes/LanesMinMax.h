// The lesser and the greater of two reals per lane, by the processor's instruction. Compilers do not find it in a
// comparison and a choice of lanes.
#pragma once

#include "LanesTypes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{
namespace Impl
{

/** A < B ? A : B; so B where one is NaN, or both are zero. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Lesser(TReal<Real, N> A, TReal<Real, N> B)
{
	[[maybe_unused]] constexpr bool bFloat = sizeof(Real) == 4;
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (bFloat && N == 16)
	{
#if defined(__clang__)
		return TReal<Real, N>(__builtin_ia32_minps512(A.V, B.V, 4));
#else
		return TReal<Real, N>(__builtin_ia32_minps512_mask(A.V, B.V, A.V, uint16_t(0xFFFF), 4));
#endif
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (bFloat && N == 8)
	{
		return TReal<Real, N>(__builtin_ia32_minps256(A.V, B.V));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 2
		if constexpr (bFloat && N == 4)
	{
		return TReal<Real, N>(__builtin_ia32_minps(A.V, B.V));
	}
	else
#endif
	{
		return Select(A < B, A, B);
	}
}

/** A > B ? A : B; so B where one is NaN, or both are zero. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Greater(TReal<Real, N> A, TReal<Real, N> B)
{
	[[maybe_unused]] constexpr bool bFloat = sizeof(Real) == 4;
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (bFloat && N == 16)
	{
#if defined(__clang__)
		return TReal<Real, N>(__builtin_ia32_maxps512(A.V, B.V, 4));
#else
		return TReal<Real, N>(__builtin_ia32_maxps512_mask(A.V, B.V, A.V, uint16_t(0xFFFF), 4));
#endif
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (bFloat && N == 8)
	{
		return TReal<Real, N>(__builtin_ia32_maxps256(A.V, B.V));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 2
		if constexpr (bFloat && N == 4)
	{
		return TReal<Real, N>(__builtin_ia32_maxps(A.V, B.V));
	}
	else
#endif
	{
		return Select(A > B, A, B);
	}
}

} // namespace Impl
} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
