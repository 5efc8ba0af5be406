// Pow: exp2(y * log2(x)) as in Direct3D, within 1 ulp: NaN for a negative x, and 1 for y = 0 with any other x but NaN.
// The logarithm and its product with y are float-float, by products that are rounded once (Fused). Bits as in
// LanesElementary.h: of one fixed sequence of operations. Double lanes call the C library one by one. Polynomials:
// fits of least greatest error, made for drydock.
#pragma once

#include "LanesElementary.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{
namespace Impl
{

/** Horner's rule with one rounding a step, the highest power first. */
template<int N, typename... T>
DRYDOCK_LANES_INLINE TReal<float, N> FusedPolynomial(TReal<float, N> X, float Highest, T... Lower)
{
	TReal<float, N> Result = Highest;
	((Result = Fused(Result, X, TReal<float, N>(Lower))), ...);
	return Result;
}

/** Table[Index modulo 16], which is one instruction where a register holds the table. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> PickOfSixteen(const float (&Table)[16], TRaw<int32_t, N> Index)
{
	using FLanes = TReal<float, N>;
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (N == 16)
	{
		TRaw<float, 16> All;
		__builtin_memcpy(&All, Table, sizeof(All));
#if defined(__clang__)
		return FLanes(__builtin_ia32_permvarsf512(All, Index));
#else
		return FLanes(__builtin_ia32_permvarsf512_mask(All, Index, All, uint16_t(0xFFFF)));
#endif
	}
	else
#endif
#if DRYDOCK_LANES_LEVEL >= 3
		if constexpr (N == 8)
	{
		TRaw<float, 8> Halves[2];
		__builtin_memcpy(Halves, Table, sizeof(Halves));
		return Select(TMask<8>(Index << 28), FLanes(__builtin_ia32_permvarsf256(Halves[1], Index)),
			FLanes(__builtin_ia32_permvarsf256(Halves[0], Index)));
	}
	else
#endif
	{
		FLanes Result;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Result.V[Lane] = Table[Index[Lane] & 15];
		}
		return Result;
	}
}

/** c of the sixteen pieces of the octave around 1, about the reciprocal of the piece's middle, and -log2(c) in two
 * parts, the high one so short that with an exponent it stays exact. */
constexpr float LogScales[16] = {1.375f, 1.34375f, 1.28125f, 1.21875f, 1.1875f, 1.15625f, 1.09375f, 1.0625f, 1.03125f,
	1.0f, 0.9375f, 0.890625f, 0.84375f, 0.796875f, 0.765625f, 0.71875f};
constexpr float LogsHigh[16] = {-30109 / 65536.f, -27936 / 65536.f, -23433 / 65536.f, -18704 / 65536.f,
	-16248 / 65536.f, -13727 / 65536.f, -8473 / 65536.f, -5732 / 65536.f, -2909 / 65536.f, 0.0f, 6102 / 65536.f,
	10952 / 65536.f, 16064 / 65536.f, 21468 / 65536.f, 25250 / 65536.f, 31224 / 65536.f};
constexpr float LogsLow[16] = {-4.73875434e-06f, 4.77654794e-06f, 7.19948366e-06f, -1.82823726e-06f, -2.70875603e-06f,
	4.03183185e-06f, 4.70278155e-06f, 5.37655922e-07f, -6.30197565e-06f, 0.0f, 2.73532095e-07f, -4.2719771e-06f,
	-4.68966346e-06f, -1.02556521e-06f, 5.73205671e-06f, -2.38574444e-06f};

/** High + Low, Low much the smaller: what one float is too short for. */
template<int N>
struct TFloatPair
{
	TReal<float, N> High;
	TReal<float, N> Low;
};

/** log2(X) of positive normal X to about 2^-33 of itself: exponent - log2(c) + log2(1 + R), R = c m - 1, m the
 * mantissa, c of its piece. c is so short that R is exact and below 1/30; around 1 it is 1, so that nothing cancels. */
template<int N>
DRYDOCK_LANES_INLINE TFloatPair<N> Log2Pair(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	constexpr uint32_t Origin = 0x3F3428F6; // 0.70375: its pieces have such c
	const auto Above = TRaw<int32_t, N>(TRaw<uint32_t, N>(X.V) - Origin);
	const TRaw<int32_t, N> Exponent = Above >> 23;
	const TRaw<int32_t, N> Piece = Above >> 19;
	const FLanes R = Fused(Scaled(X, Exponent), PickOfSixteen<N>(LogScales, Piece), FLanes(-1.0f));

	// R - R^2 / 2 in two floats, and the rest of the series.
	const FLanes MinusHalf = R * FLanes(-0.5f);
	const FLanes Bend = Fused(MinusHalf, R, R);
	const FLanes BendLow = Fused(MinusHalf, R, R - Bend);
	const FLanes Log2E = 1.44269502f;
	const FLanes Log2ELow = 1.92596303e-08f;
	const FLanes Series = FusedPolynomial(R, -0.240641356f, 0.288866669f, -0.360673726f, 0.480898231f);
	const FLanes Base = FLanes(__builtin_convertvector(Exponent, TRaw<float, N>)) + PickOfSixteen<N>(LogsHigh, Piece);
	const FLanes High = Fused(Bend, Log2E, Base);
	const FLanes Low = Fused(Bend, Log2E, Base - High) + PickOfSixteen<N>(LogsLow, Piece);
	return {High, Fused(R * R * R, Series, Fused(BendLow, Log2E, Fused(Bend, Log2ELow, Low)))};
}

/** 2^Whole 2^F, |F| <= 1/2, as an integer's bits: those of 2^F, which lies in [0.7, 1.42), and the exponent's. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> Exp2Bits(TReal<float, N> Whole, TReal<float, N> F)
{
	const TReal<float, N> Power = FusedPolynomial(
		F, 0.000153293804f, 0.00133909762f, 0.00961849932f, 0.0555035956f, 0.240226477f, 0.693147182f, 1.0f);
	return TInt<N>(TRaw<int32_t, N>(Power.V) + (ToIntUnchecked(Whole).V << 23));
}

/** Pow of any lanes, to which belong those whose result lies beyond 2^126 or below 2^-126, and those where x or y is
 *  zero, infinite, NaN, negative or below the smallest normal number: log2 of 0 and of infinity is an infinity with a
 *  sign; times y it decides between 0 and infinity. Product + ProductLow: y log2(x), for positive normal x. */
template<int N>
__attribute__((noinline)) TReal<float, N> PowOfAny(
	TReal<float, N> X, TReal<float, N> Y, TReal<float, N> Product, TReal<float, N> ProductLow)
{
	using FLanes = TReal<float, N>;
	const FLanes Zero = 0.0f;
	const FLanes Infinite = InfinityF;

	// A product beyond the bounds gives 0 or infinity whatever its low part.
	const FLanes Bounded = Max(Min(Product, FLanes(128.5f)), FLanes(-127.0f));
	const FLanes Low = Select(Product == Bounded, ProductLow, Zero);
	const FLanes Whole = RoundTo<Nearest>(Bounded + Low);
	const FLanes F = (Bounded - Whole) + Low;
	const TMask<N> bVanishes = Whole < FLanes(-126.0f) || (Whole == FLanes(-126.0f) && F < Zero);
	const TInt<N> Finite = Min(Select(bVanishes, TInt<N>(0), Exp2Bits(Whole, F)), TInt<N>(0x7F800000));

	const TMask<N> bZero = Abs(X) < FLanes(SmallestNormal);
	const FLanes OfZero = Select(Y > Zero, Zero, Infinite);
	const FLanes OfInfinity = Select(Y > Zero, Infinite, Zero);
	FLanes Result = FLanes(TRaw<float, N>(Finite.V));
	Result = Select(bZero, OfZero, Select(X == Infinite, OfInfinity, Result));
	Result = Select(Abs(Y) == Infinite && X == FLanes(1.0f), FLanes(__builtin_nanf("")), Result); // Inf * 0
	Result = Select(Abs(Y) < FLanes(SmallestNormal), FLanes(1.0f), Result);
	Result = Select(X < Zero && !bZero, FLanes(__builtin_nanf("")), Result);
	return Select(X == X, Select(Y == Y, Result, Y), X);
}

/** The error of the product y log2(x) counts up to 128 times in the result: product and logarithm have two floats.
 * Lanes have the same bits whether or not others of their pack are ordinary. */
template<int N>
TReal<float, N> Pow(TReal<float, N> X, TReal<float, N> Y)
{
	using FLanes = TReal<float, N>;
	const TFloatPair<N> Log = Log2Pair(X);
	const FLanes Product = Y * Log.High;
	const FLanes ProductLow = Fused(Y, Log.Low, Fused(Y, Log.High, -Product));
	const TUint<N> AboveSmallest(TRaw<uint32_t, N>(X.V) - 0x00800000u);
	const TMask<N> bOrdinary = AboveSmallest < TUint<N>(0x7F000000u) && Abs(Product) < FLanes(126.0f);
	if (__builtin_expect(!AllLanes(bOrdinary), 0))
	{
		return PowOfAny(X, Y, Product, ProductLow);
	}
	const FLanes Whole = RoundTo<Nearest>(Product + ProductLow);
	return FLanes(TRaw<float, N>(Exp2Bits(Whole, (Product - Whole) + ProductLow).V));
}

template<int N>
inline TReal<double, N> Pow(TReal<double, N> X, TReal<double, N> Y)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const double Base = X.V[Lane];
		X.V[Lane] = Base != Base || Base < 0 ? __builtin_nan("") : __builtin_pow(Base, Y.V[Lane]);
	}
	return X;
}

} // namespace Impl

DRYDOCK_LANES_BINARY(Pow, Impl::Pow(x, y))

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
