// Arithmetic intrinsics with Direct3D's rules, for uniform scalars, lanes and vectors of either. Every operation is a
// fixed sequence of IEEE operations, so bits depend neither on the lane count nor on the instruction set.
// Source: D3D11 functional specification 22; drydock.
#pragma once

#include "LanesConvert.h"
#include "LanesMinMax.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** The lane implementations; the names without a prefix below take any mix of uniform, lanes and vectors. */
namespace Impl
{

enum ERounding
{
	Nearest = 8,
	Down = 9,
	Up = 10,
	TowardsZero = 11
};

template<ERounding Mode, typename Real>
DRYDOCK_LANES_INLINE Real RoundScalar(Real X)
{
	if constexpr (Mode == Nearest)
	{
		return __builtin_rint(X);
	}
	else if constexpr (Mode == Down)
	{
		return __builtin_floor(X);
	}
	else if constexpr (Mode == Up)
	{
		return __builtin_ceil(X);
	}
	else
	{
		return __builtin_trunc(X);
	}
}

template<ERounding Mode, typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> RoundTo(TReal<Real, N> X)
{
	using FLanes = TReal<Real, N>;
	[[maybe_unused]] constexpr bool bFloat = sizeof(Real) == 4;
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (bFloat && N == 16)
	{
		return FLanes(__builtin_ia32_rndscaleps_mask(X.V, Mode, X.V, uint16_t(0xFFFF), 4));
	}
	else if constexpr (!bFloat && N == 8)
	{
		return FLanes(__builtin_ia32_rndscalepd_mask(X.V, Mode, X.V, uint8_t(0xFF), 4));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (bFloat && N == 8)
	{
		return FLanes(__builtin_ia32_roundps256(X.V, Mode));
	}
	else if constexpr (!bFloat && N == 4)
	{
		return FLanes(__builtin_ia32_roundpd256(X.V, Mode));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 2
		if constexpr (bFloat && N == 4)
	{
		return FLanes(__builtin_ia32_roundps(X.V, Mode));
	}
	else if constexpr (!bFloat && N == 2)
	{
		return FLanes(__builtin_ia32_roundpd(X.V, Mode));
	}
	else
#endif
	{
		FLanes Result;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Result.V[Lane] = RoundScalar<Mode>(X.V[Lane]);
		}
		return Result;
	}
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Sqrt(TReal<Real, N> X)
{
	using FLanes = TReal<Real, N>;
	[[maybe_unused]] constexpr bool bFloat = sizeof(Real) == 4;
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (bFloat && N == 16)
	{
#if defined(__clang__)
		return FLanes(__builtin_ia32_sqrtps512(X.V, 4));
#else
		return FLanes(__builtin_ia32_sqrtps512_mask(X.V, X.V, uint16_t(0xFFFF), 4));
#endif
	}
	else if constexpr (!bFloat && N == 8)
	{
#if defined(__clang__)
		return FLanes(__builtin_ia32_sqrtpd512(X.V, 4));
#else
		return FLanes(__builtin_ia32_sqrtpd512_mask(X.V, X.V, uint8_t(0xFF), 4));
#endif
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (bFloat && N == 8)
	{
		return FLanes(__builtin_ia32_sqrtps256(X.V));
	}
	else if constexpr (!bFloat && N == 4)
	{
		return FLanes(__builtin_ia32_sqrtpd256(X.V));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 2
		if constexpr (bFloat && N == 4)
	{
		return FLanes(__builtin_ia32_sqrtps(X.V));
	}
	else if constexpr (!bFloat && N == 2)
	{
		return FLanes(__builtin_ia32_sqrtpd(X.V));
	}
	else
#endif
	{
		FLanes Result;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Result.V[Lane] = bFloat ? Real(__builtin_sqrtf(float(X.V[Lane]))) : Real(__builtin_sqrt(X.V[Lane]));
		}
		return Result;
	}
}

/** P + C rounded to odd: an inexact sum that is even moves one bit towards what was lost. If P is the product of two
 * floats and C a float, rounding the result to float is rounding the exact sum once (double has 2 * 24 + 5 bits). */
template<int H>
DRYDOCK_LANES_INLINE TRaw<double, H> AddToOdd(TRaw<double, H> P, TRaw<double, H> C)
{
	using FBits = TRaw<int64_t, H>;
	const TRaw<double, H> Sum = P + C;
	const TRaw<double, H> Part = Sum - P;
	const TRaw<double, H> Error = (P - (Sum - Part)) + (C - Part);
	const FBits bInexact = (Error < 0) | (Error > 0); // not where the sum is infinite and its error NaN
	const FBits Direction = ((Error > 0) == (Sum > 0)) | 1;
	const FBits Step = bInexact & ~-(FBits(Sum) & 1) & -Direction;
	return TRaw<double, H>(FBits(Sum) + Step);
}

/** X * Y + Z, rounded once. If the instruction set has no such operation, the result is found in double. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Fused(TReal<Real, N> X, TReal<Real, N> Y, TReal<Real, N> Z)
{
	using FLanes = TReal<Real, N>;
	[[maybe_unused]] constexpr bool bFloat = sizeof(Real) == 4;
#if DRYDOCK_LANES_LEVEL >= 3 && __has_builtin(__builtin_elementwise_fma)
	return FLanes(__builtin_elementwise_fma(X.V, Y.V, Z.V));
#else
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (bFloat && N == 16)
	{
		return FLanes(__builtin_ia32_vfmaddps512_mask(X.V, Y.V, Z.V, uint16_t(0xFFFF), 4));
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (bFloat && N == 8)
	{
		return FLanes(__builtin_ia32_vfmaddps256(X.V, Y.V, Z.V));
	}
	else if constexpr (bFloat && N == 4)
	{
		return FLanes(__builtin_ia32_vfmaddps(X.V, Y.V, Z.V));
	}
	else
#endif
		if constexpr (bFloat)
	{
		using FWide = TRaw<double, N>;
		constexpr int H = N > 1 ? N / 2 : 1; // what fills a register; wider comparisons would go lane by lane
		const FWide Product = __builtin_convertvector(X.V, FWide) * __builtin_convertvector(Y.V, FWide);
		const FWide Summand = __builtin_convertvector(Z.V, FWide);
		TRaw<double, H> P[N / H], C[N / H];
		__builtin_memcpy(P, &Product, sizeof(P));
		__builtin_memcpy(C, &Summand, sizeof(C));
		for (int i = 0; i < N / H; ++i)
		{
			P[i] = AddToOdd<H>(P[i], C[i]);
		}
		FWide Sum;
		__builtin_memcpy(&Sum, P, sizeof(P));
		return FLanes(__builtin_convertvector(Sum, TRaw<float, N>));
	}
	else
	{
		FLanes Result;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Result.V[Lane] = __builtin_fma(X.V[Lane], Y.V[Lane], Z.V[Lane]);
		}
		return Result;
	}
#endif
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Abs(TReal<Real, N> X)
{
	using FBits = typename TReal<Real, N>::FBits;
	constexpr auto Sign = sizeof(Real) == 4 ? int64_t(0x7FFFFFFF) : int64_t(0x7FFFFFFFFFFFFFFF);
	using FBit = std::remove_cvref_t<decltype(FBits{}[0])>;
	return TReal<Real, N>(TRaw<Real, N>(FBits(X.V) & FBit(Sign)));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> Abs(TInt<N> X)
{
	return Select(X < TInt<N>(0), -X, X);
}

// A NaN operand loses against a number.
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Min(TReal<Real, N> A, TReal<Real, N> B)
{
	return Select(B == B, Lesser(A, B), A);
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Max(TReal<Real, N> A, TReal<Real, N> B)
{
	return Select(B == B, Greater(A, B), A);
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> Min(TInt<N> A, TInt<N> B)
{
	return Select(A < B, A, B);
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> Max(TInt<N> A, TInt<N> B)
{
	return Select(A > B, A, B);
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> Min(TUint<N> A, TUint<N> B)
{
	return Select(A < B, A, B);
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> Max(TUint<N> A, TUint<N> B)
{
	return Select(A > B, A, B);
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Saturate(TReal<Real, N> X)
{
	const TReal<Real, N> Zero = Real(0);
	const TReal<Real, N> One = Real(1);
	return Lesser(Greater(X, Zero), One);
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Sign(TReal<Real, N> X)
{
	const TReal<Real, N> Zero = Real(0);
	return Select(X > Zero, TReal<Real, N>(Real(1)), Select(X < Zero, TReal<Real, N>(Real(-1)), Zero));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> Sign(TInt<N> X)
{
	return TInt<N>((X.V < 0) | -(X.V > 0));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Mix(TReal<Real, N> A, TReal<Real, N> B, TReal<Real, N> T)
{
	return A + T * (B - A);
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> SmoothStep(TReal<Real, N> A, TReal<Real, N> B, TReal<Real, N> X)
{
	const TReal<Real, N> T = Saturate((X - A) / (B - A));
	return T * T * (TReal<Real, N>(Real(3)) - TReal<Real, N>(Real(2)) * T);
}

template<int N>
DRYDOCK_LANES_INLINE TUint<N> BitCount(TUint<N> X)
{
	TRaw<uint32_t, N> V = X.V;
	V = V - ((V >> 1) & 0x55555555u);
	V = (V & 0x33333333u) + ((V >> 2) & 0x33333333u);
	V = (V + (V >> 4)) & 0x0F0F0F0Fu;
	return TUint<N>((V * 0x01010101u) >> 24);
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> BitReverse(TUint<N> X)
{
	TRaw<uint32_t, N> V = X.V;
	V = ((V >> 1) & 0x55555555u) | ((V & 0x55555555u) << 1);
	V = ((V >> 2) & 0x33333333u) | ((V & 0x33333333u) << 2);
	V = ((V >> 4) & 0x0F0F0F0Fu) | ((V & 0x0F0F0F0Fu) << 4);
	V = ((V >> 8) & 0x00FF00FFu) | ((V & 0x00FF00FFu) << 8);
	return TUint<N>((V >> 16) | (V << 16));
}
/** Index of the lowest set bit, -1 when there is none. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> FindLsb(TUint<N> X)
{
	const TInt<N> Index = ToInt(BitCount(TUint<N>(~X.V & (X.V - 1u))));
	return Select(X == TUint<N>(0u), TInt<N>(-1), Index);
}
/** Index of the highest set bit, counted from bit 0; -1 when there is none. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> FindMsb(TUint<N> X)
{
	TRaw<uint32_t, N> V = X.V;
	V |= V >> 1;
	V |= V >> 2;
	V |= V >> 4;
	V |= V >> 8;
	V |= V >> 16;
	return ToInt(BitCount(TUint<N>(V))) - TInt<N>(1);
}
/** The highest set bit; of a negative number the highest clear bit. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> FindMsb(TInt<N> X)
{
	return FindMsb(ToUint(TInt<N>(X.V ^ (X.V >> 31))));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> FindLsb(TInt<N> X)
{
	return FindLsb(ToUint(X));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> BitCount(TInt<N> X)
{
	return ToInt(BitCount(ToUint(X)));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> BitReverse(TInt<N> X)
{
	return ToInt(BitReverse(ToUint(X)));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Ldexp(TReal<Real, N> X, TInt<N> Exponent)
{
	// Two factors reach every result from every operand; one would leave the exponent range.
	constexpr int Bias = sizeof(Real) == 4 ? 127 : 1023;
	constexpr int MantissaBits = sizeof(Real) == 4 ? 23 : 52;
	using FBits = typename TReal<Real, N>::FBits;
	const TInt<N> Clamped = Max(Min(Exponent, TInt<N>(2 * Bias)), TInt<N>(2 - 2 * Bias));
	const TRaw<int32_t, N> First = Clamped.V >> 1;
	const TRaw<int32_t, N> Second = Clamped.V - First;
	const FBits FirstBits = __builtin_convertvector(First + Bias, FBits) << MantissaBits;
	const FBits SecondBits = __builtin_convertvector(Second + Bias, FBits) << MantissaBits;
	return X * TReal<Real, N>(TRaw<Real, N>(FirstBits)) * TReal<Real, N>(TRaw<Real, N>(SecondBits));
}

} // namespace Impl

// Any scalar, any vector, for a function of lanes.
#define DRYDOCK_LANES_UNARY(Name, Expression) \
	template<CLanes T> \
	DRYDOCK_LANES_INLINE auto Name(T x) \
	{ \
		return Expression; \
	} \
	template<CUniform T> \
	DRYDOCK_LANES_INLINE auto Name(T x) \
	{ \
		return First(Name(Widen(x))); \
	} \
	template<typename T, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<T, n>& v) \
	{ \
		return Map([](const T& c) { return Name(c); }, v); \
	}
#define DRYDOCK_LANES_BINARY(Name, Expression) \
	template<CScalar A, CScalar B> \
	DRYDOCK_LANES_INLINE auto Name(A InX, B InY) \
	{ \
		using T = Meet<A, B>; \
		if constexpr (CUniform<T>) \
		{ \
			return First(Name(Widen(T(InX)), Widen(T(InY)))); \
		} \
		else \
		{ \
			const T x = T(InX); \
			const T y = T(InY); \
			return Expression; \
		} \
	} \
	template<typename A, typename B, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<A, n>& a, const TVec<B, n>& b) \
	{ \
		return Map([](const A& c, const B& d) { return Name(c, d); }, a, b); \
	}
#define DRYDOCK_LANES_TERNARY(Name, Expression) \
	template<CScalar A, CScalar B, CScalar C> \
	DRYDOCK_LANES_INLINE auto Name(A InX, B InY, C InZ) \
	{ \
		using T = Meet<Meet<A, B>, C>; \
		if constexpr (CUniform<T>) \
		{ \
			return First(Name(Widen(T(InX)), Widen(T(InY)), Widen(T(InZ)))); \
		} \
		else \
		{ \
			const T x = T(InX); \
			const T y = T(InY); \
			const T z = T(InZ); \
			return Expression; \
		} \
	} \
	template<typename A, typename B, typename C, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<A, n>& a, const TVec<B, n>& b, const TVec<C, n>& c) \
	{ \
		return Map([](const A& d, const B& e, const C& f) { return Name(d, e, f); }, a, b, c); \
	}

/** A constant in the lanes of x. */
#define DRYDOCK_LANES_CONSTANT(Value) T(std::remove_cvref_t<decltype(x.V[0])>(Value))

DRYDOCK_LANES_UNARY(Abs, Impl::Abs(x))
DRYDOCK_LANES_UNARY(Sign, Impl::Sign(x))
DRYDOCK_LANES_UNARY(Floor, Impl::RoundTo<Impl::Down>(x))
DRYDOCK_LANES_UNARY(Ceil, Impl::RoundTo<Impl::Up>(x))
DRYDOCK_LANES_UNARY(Trunc, Impl::RoundTo<Impl::TowardsZero>(x))
DRYDOCK_LANES_UNARY(RoundEven, Impl::RoundTo<Impl::Nearest>(x)) // HLSL's round
DRYDOCK_LANES_UNARY(Round, Impl::RoundTo<Impl::Nearest>(x))
DRYDOCK_LANES_UNARY(Frac, x - Impl::RoundTo<Impl::Down>(x))
DRYDOCK_LANES_UNARY(Sqrt, Impl::Sqrt(x))
DRYDOCK_LANES_UNARY(InverseSqrt, DRYDOCK_LANES_CONSTANT(1) / Impl::Sqrt(x))
DRYDOCK_LANES_UNARY(Saturate, Impl::Saturate(x))
DRYDOCK_LANES_UNARY(IsNan, x != x)
DRYDOCK_LANES_UNARY(IsInf, Impl::Abs(x) == DRYDOCK_LANES_CONSTANT(__builtin_inf()))
DRYDOCK_LANES_UNARY(IsFinite, Impl::Abs(x) < DRYDOCK_LANES_CONSTANT(__builtin_inf()))
DRYDOCK_LANES_UNARY(Degrees, x* DRYDOCK_LANES_CONSTANT(57.295779513082320877))
DRYDOCK_LANES_UNARY(Radians, x* DRYDOCK_LANES_CONSTANT(0.017453292519943295769))
DRYDOCK_LANES_UNARY(BitCount, Impl::BitCount(x))
DRYDOCK_LANES_UNARY(BitReverse, Impl::BitReverse(x))
DRYDOCK_LANES_UNARY(FindLsb, Impl::FindLsb(x))
DRYDOCK_LANES_UNARY(FindMsb, Impl::FindMsb(x))

DRYDOCK_LANES_BINARY(Min, Impl::Min(x, y))
DRYDOCK_LANES_BINARY(Max, Impl::Max(x, y))
DRYDOCK_LANES_BINARY(Step, Select(y >= x, DRYDOCK_LANES_CONSTANT(1), DRYDOCK_LANES_CONSTANT(0)))
DRYDOCK_LANES_BINARY(FMod, x - y * Impl::RoundTo<Impl::Down>(x / y))
DRYDOCK_LANES_BINARY(FRem, x - y * Impl::RoundTo<Impl::TowardsZero>(x / y))

DRYDOCK_LANES_TERNARY(Clamp, Impl::Min(Impl::Max(x, y), z))
DRYDOCK_LANES_TERNARY(Mix, Impl::Mix(x, y, z))
DRYDOCK_LANES_TERNARY(SmoothStep, Impl::SmoothStep(x, y, z))
DRYDOCK_LANES_TERNARY(Fma, x* y + z) // HLSL's mad: rounded twice
DRYDOCK_LANES_TERNARY(Fused, Impl::Fused(x, y, z))

template<CScalar A, CScalar B>
DRYDOCK_LANES_INLINE auto Ldexp(A X, B Exponent)
{
	if constexpr (CUniform<A> && CUniform<B>)
	{
		constexpr int N = sizeof(A) == 4 ? 4 : 2;
		return Impl::Ldexp(TReal<A, N>(X), TInt<N>(Exponent))[0];
	}
	else if constexpr (CUniform<A>)
	{
		return Impl::Ldexp(TReal<A, sizeof(B) / 4>(X), Exponent);
	}
	else
	{
		return Impl::Ldexp(X, TInt<sizeof(A) / sizeof(X[0])>(Exponent));
	}
}
template<typename A, typename B, int n>
DRYDOCK_LANES_INLINE auto Ldexp(const TVec<A, n>& a, const TVec<B, n>& b)
{
	return Map([](const A& c, const B& d) { return Ldexp(c, d); }, a, b);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
