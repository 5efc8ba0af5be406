// Elementary functions over lanes. Source: drydock.
#pragma once

#include "LanesMath.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

#define DRYDOCK_LANES_LIBM(Name, Function)                                                                             \
	namespace Impl                                                                                                     \
	{                                                                                                                  \
	template <typename Real, int N>                                                                                    \
	TReal<Real, N> Name(TReal<Real, N> X)                                                                              \
	{                                                                                                                  \
		for (int Lane = 0; Lane < N; ++Lane)                                                                           \
		{                                                                                                              \
			X.V[Lane] = Real(__builtin_##Function(double(X.V[Lane])));                                                 \
		}                                                                                                              \
		return X;                                                                                                      \
	}                                                                                                                  \
	}                                                                                                                  \
	DRYDOCK_LANES_UNARY(Name, Impl::Name(x))
DRYDOCK_LANES_LIBM(Exp2, exp2)
DRYDOCK_LANES_LIBM(Log2, log2)
DRYDOCK_LANES_LIBM(Exp, exp)
DRYDOCK_LANES_LIBM(Log, log)
DRYDOCK_LANES_LIBM(Sin, sin)
DRYDOCK_LANES_LIBM(Cos, cos)
DRYDOCK_LANES_LIBM(Tan, tan)
DRYDOCK_LANES_LIBM(Asin, asin)
DRYDOCK_LANES_LIBM(Acos, acos)
DRYDOCK_LANES_LIBM(Atan, atan)
DRYDOCK_LANES_LIBM(Sinh, sinh)
DRYDOCK_LANES_LIBM(Cosh, cosh)
DRYDOCK_LANES_LIBM(Tanh, tanh)

namespace Impl
{
template <typename Real, int N>
TReal<Real, N> Pow(TReal<Real, N> X, TReal<Real, N> Y)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		X.V[Lane] = Real(__builtin_pow(double(X.V[Lane]), double(Y.V[Lane])));
	}
	return X;
}
template <typename Real, int N>
TReal<Real, N> Atan2(TReal<Real, N> X, TReal<Real, N> Y)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		X.V[Lane] = Real(__builtin_atan2(double(X.V[Lane]), double(Y.V[Lane])));
	}
	return X;
}
} // namespace Impl
DRYDOCK_LANES_BINARY(Pow, Impl::Pow(x, y))
DRYDOCK_LANES_BINARY(Atan2, Impl::Atan2(x, y)) // y first, as in HLSL

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
