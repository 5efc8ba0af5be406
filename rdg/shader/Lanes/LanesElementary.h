// Elementary functions. In float each is one fixed sequence of operations for every lane count, instruction set and
// uniform scalars: same input, same bits. Errors in units in the last place, proven by sweeps in the tests:
//   Exp2 Exp Log2 Log 2, Sin Cos 2 for |x| <= 8192 (bounded but meaningless beyond 10^6), Tan 4,
//   Asin Acos Atan Atan2 3, Sinh Cosh Tanh 4; Pow (LanesPow.h) 1
// Exponentials, logarithms and Pow give 0 below the smallest normal float and take arguments below it as 0, whatever
// the processor's denormal mode; the others follow the mode. Double lanes call the C library one by one. Polynomials:
// Chebyshev fits made for drydock.
// Source of the argument reductions: W. J. Cody and W. Waite, Software Manual for the Elementary Functions (1980).
#pragma once

#include "LanesMath.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{
namespace Impl
{

constexpr float SmallestNormal = 0x1p-126f;
constexpr float InfinityF = __builtin_inff();

/** Horner's rule, the highest power first. */
template<typename Real, int N, typename... T>
DRYDOCK_LANES_INLINE TReal<Real, N> Polynomial(TReal<Real, N> X, Real Highest, T... Lower)
{
	TReal<Real, N> Result = Highest;
	((Result = Result * X + TReal<Real, N>(Lower)), ...);
	return Result;
}

/** 2^Exponent for -126 .. 127. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> PowerOfTwo(TInt<N> Exponent)
{
	return TReal<float, N>(TRaw<float, N>((Exponent.V + 127) << 23));
}

/** Value * 2^Exponent in two exact steps, so that an exponent of 128 reaches infinity only by overflow. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> Scale(TReal<float, N> Value, TInt<N> Exponent)
{
	const TInt<N> Half(Exponent.V >> 1);
	return Value * PowerOfTwo(Half) * PowerOfTwo(Exponent - Half);
}

/** Integer part of a float that is known to fit. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ToIntUnchecked(TReal<float, N> X)
{
	return TInt<N>(__builtin_convertvector(X.V, TRaw<int32_t, N>));
}

/** 2^F, |F| <= 1/2. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> Exp2Fraction(TReal<float, N> F)
{
	return F * Polynomial(F, 1.52973244e-05f, 0.000154614449f, 0.0013333502f, 0.00961805694f, 0.0555041097f,
				   0.240226507f, 0.693147182f) +
		   TReal<float, N>(1.0f);
}

template<int N>
TReal<float, N> Exp2(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes Bounded = Max(Min(X, FLanes(130.0f)), FLanes(-130.0f)); // NaN becomes a bound
	const FLanes Whole = RoundTo<Nearest>(Bounded);
	const FLanes Result = Scale(Exp2Fraction(Bounded - Whole), ToIntUnchecked(Whole));
	return Select(X < FLanes(-126.0f), FLanes(0.0f), Select(X == X, Result, X));
}

template<int N>
TReal<float, N> Exp(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes Bounded = Max(Min(X, FLanes(90.0f)), FLanes(-90.0f));
	const FLanes Whole = RoundTo<Nearest>(Bounded * FLanes(1.44269502f));
	// ln 2 in two parts, the first short enough for an exact product.
	const FLanes R = (Bounded - Whole * FLanes(0.693359375f)) - Whole * FLanes(-2.12194442e-4f);
	const FLanes Result = Scale(
		R * R * Polynomial(R, 0.000198909809f, 0.00139336416f, 0.00833331048f, 0.0416664667f, 0.166666672f, 0.5f) + R +
			FLanes(1.0f),
		ToIntUnchecked(Whole));
	return Select(X < FLanes(-87.3365402f), FLanes(0.0f), Select(X == X, Result, X));
}

/** E such that X / 2^E lies in [sqrt(1/2), sqrt(2)), for positive normal X; anything for others. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<int32_t, N> LogExponent(TReal<float, N> X)
{
	return TRaw<int32_t, N>(TRaw<uint32_t, N>(X.V) - 0x3F3504F3u) >> 23;
}

/** X / 2^Exponent by its bits. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> Scaled(TReal<float, N> X, TRaw<int32_t, N> Exponent)
{
	return TReal<float, N>(TRaw<float, N>(TRaw<uint32_t, N>(X.V) - (TRaw<uint32_t, N>(Exponent) << 23)));
}

/** X = 2^Exponent (1 + T), T in [sqrt(1/2) - 1, sqrt(2) - 1); ln(1 + T) = T + Rest. X positive and normal. */
template<int N>
struct TLogParts
{
	TReal<float, N> Exponent;
	TReal<float, N> T;
	TReal<float, N> Rest;
};

template<int N>
DRYDOCK_LANES_INLINE TLogParts<N> SplitLog(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const TRaw<int32_t, N> Exponent = LogExponent(X);
	const FLanes T = Scaled(X, Exponent) - FLanes(1.0f);
	const FLanes T2 = T * T;
	const FLanes Rest = T2 * T *
							Polynomial(T, -0.0620150007f, 0.105308644f, -0.10646192f, 0.110377833f, -0.124507435f,
								0.142865241f, -0.166680008f, 0.200000107f, -0.249999896f, 0.333333343f) -
						T2 * FLanes(0.5f);
	return {FLanes(__builtin_convertvector(Exponent, TRaw<float, N>)), T, Rest};
}

/** Sets the values of a logarithm outside the positive normal numbers. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> FinishLog(TReal<float, N> X, TReal<float, N> Result)
{
	using FLanes = TReal<float, N>;
	const FLanes Below = Select(X < FLanes(0.0f), FLanes(__builtin_nanf("")), Result);
	const FLanes Zero = Select(Abs(X) < FLanes(SmallestNormal), FLanes(-InfinityF), Below);
	return Select(X < FLanes(InfinityF), Zero, X); // +Inf and NaN stay
}

template<int N>
TReal<float, N> Log2(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const TLogParts<N> P = SplitLog(X);
	const FLanes Log2EMinusOne = 0.442695051f;
	return FinishLog(X, P.Rest * Log2EMinusOne + P.T * Log2EMinusOne + P.Rest + P.T + P.Exponent);
}

template<int N>
TReal<float, N> Log(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const TLogParts<N> P = SplitLog(X);
	return FinishLog(X, P.Rest + P.Exponent * FLanes(-2.12194442e-4f) + P.T + P.Exponent * FLanes(0.693359375f));
}

/** f, a function of TReal<double, N / 2>, over both halves: each half fills one register. Gives two results. */
template<int N, typename F>
DRYDOCK_LANES_INLINE void ForHalves(TReal<float, N> X, F f)
{
	constexpr int H = N / 2;
	TRaw<float, H> Parts[2];
	__builtin_memcpy(Parts, &X, sizeof(Parts));
	for (int i = 0; i < 2; ++i)
	{
		f(i, TReal<double, H>(__builtin_convertvector(Parts[i], TRaw<double, H>)));
	}
}

/** X = Quadrant * pi / 2 + R, |R| <= pi / 4, in double: pi / 2 in two parts, the first with 33 bits. */
template<int N>
struct TAngle
{
	TReal<float, N> R;
	TInt<N> Quadrant;
};

template<int N>
DRYDOCK_LANES_INLINE TAngle<N> ReduceAngle(TReal<float, N> X)
{
	constexpr int H = N / 2;
	using FWide = TReal<double, H>;
	TRaw<float, H> Rests[2];
	TRaw<int32_t, H> Quadrants[2];
	ForHalves(X,
		[&](int i, FWide W)
		{
			const FWide Count = RoundTo<Nearest>(W * FWide(0.63661977236758134308));
			const FWide Rest = (W - Count * FWide(0x1.921fb544p+0)) - Count * FWide(0x1.0b4611a626331p-34);
			const FWide Bounded = Select(Rest < FWide(-0.8), FWide(-0.8), Select(Rest > FWide(0.8), FWide(0.8), Rest));
			const FWide Turn = Count - FWide(4.0) * RoundTo<Down>(Count * FWide(0.25));
			Rests[i] = __builtin_convertvector(Bounded.V, TRaw<float, H>);
			Quadrants[i] = __builtin_convertvector(Select(Turn == Turn, Turn, FWide(0.0)).V, TRaw<int32_t, H>);
		});
	TAngle<N> Result;
	__builtin_memcpy(&Result.R, Rests, sizeof(Rests));
	__builtin_memcpy(&Result.Quadrant, Quadrants, sizeof(Quadrants));
	return Result;
}

template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> SinReduced(TReal<float, N> R)
{
	const TReal<float, N> Z = R * R;
	return R * Z * Polynomial(Z, 2.72499256e-06f, -0.00019840087f, 0.00833333191f, -0.166666672f) + R;
}

template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> CosReduced(TReal<float, N> R)
{
	const TReal<float, N> Z = R * R;
	return Z * Z * Polynomial(Z, 2.45479423e-05f, -0.00138883025f, 0.0416666642f) - Z * TReal<float, N>(0.5f) +
		   TReal<float, N>(1.0f);
}

template<int N>
TReal<float, N> Sin(TReal<float, N> X)
{
	const TAngle<N> A = ReduceAngle(X);
	const TReal<float, N> S = Select(TMask<N>((A.Quadrant.V & 1) != 0), CosReduced(A.R), SinReduced(A.R));
	return Select(TMask<N>((A.Quadrant.V & 2) != 0), -S, S);
}

template<int N>
TReal<float, N> Cos(TReal<float, N> X)
{
	const TAngle<N> A = ReduceAngle(X);
	const TReal<float, N> C = Select(TMask<N>((A.Quadrant.V & 1) != 0), SinReduced(A.R), CosReduced(A.R));
	return Select(TMask<N>(((A.Quadrant.V + 1) & 2) != 0), -C, C);
}

template<int N>
TReal<float, N> Tan(TReal<float, N> X)
{
	const TAngle<N> A = ReduceAngle(X);
	const TReal<float, N> S = SinReduced(A.R);
	const TReal<float, N> C = CosReduced(A.R);
	const TMask<N> bOdd((A.Quadrant.V & 1) != 0);
	return Select(bOdd, -C, S) / Select(bOdd, S, C);
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> CopySign(TReal<Real, N> Magnitude, TReal<Real, N> Sign)
{
	using FBits = typename TReal<Real, N>::FBits;
	using FBit = std::conditional_t<sizeof(Real) == 4, int32_t, int64_t>;
	constexpr FBit SignBit = __builtin_bit_cast(FBit, -Real(0));
	return TReal<Real, N>(TRaw<Real, N>((FBits(Magnitude.V) & ~SignBit) | (FBits(Sign.V) & SignBit)));
}

/** High + Low is the angle's constant to double the precision of float. */
constexpr float HalfPiHigh = 1.57079637f;
constexpr float HalfPiLow = -4.37113883e-8f;

/** X >= 0 or NaN. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> AtanPositive(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const TMask<N> bSteep = X > FLanes(2.41421366f);   // tan(3 pi / 8)
	const TMask<N> bMiddle = X > FLanes(0.414213568f); // tan(pi / 8)
	const FLanes One = 1.0f;
	const FLanes T =
		Select(bSteep, -One, Select(bMiddle, X - One, X)) / Select(bSteep, X, Select(bMiddle, X + One, One));
	const FLanes High = Select(bSteep, FLanes(HalfPiHigh), Select(bMiddle, FLanes(HalfPiHigh / 2), FLanes(0.0f)));
	const FLanes Low = Select(bSteep, FLanes(HalfPiLow), Select(bMiddle, FLanes(HalfPiLow / 2), FLanes(0.0f)));
	const FLanes Z = T * T;
	return High +
		   (T * Z * Polynomial(Z, -0.0645192787f, 0.107437313f, -0.142639562f, 0.199995399f, -0.333333313f) + Low + T);
}

template<int N>
TReal<float, N> Atan(TReal<float, N> X)
{
	return CopySign(AtanPositive(Abs(X)), X);
}

/** The angle of (x, y) in -pi .. pi; 0 for the origin with x >= 0. Beside -x it is -pi for y < 0 only: D3D's compilers
 * compare y with 0, where C looks at the sign of a zero. */
template<int N>
TReal<float, N> Atan2(TReal<float, N> Y, TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes Rise = Abs(Y);
	const FLanes Run = Abs(X);
	const TMask<N> bSteep = Rise > Run;
	const FLanes Small = Select(bSteep, Run, Rise);
	const FLanes Large = Select(bSteep, Rise, Run);
	FLanes Ratio = Small / Large;
	Ratio = Select(Large == FLanes(0.0f), FLanes(0.0f), Ratio);
	Ratio = Select(Small == FLanes(InfinityF), FLanes(1.0f), Ratio);
	FLanes Angle = AtanPositive(Ratio);
	Angle = Select(bSteep, FLanes(HalfPiHigh) - (Angle - FLanes(HalfPiLow)), Angle);
	const TMask<N> bLeft(TRaw<int32_t, N>(X.V) < 0);
	Angle = Select(bLeft && X == X, FLanes(2 * HalfPiHigh) - (Angle - FLanes(2 * HalfPiLow)), Angle);
	return CopySign(Angle, Select(X < FLanes(0.0f), Y + FLanes(0.0f), Y));
}

/** asin(S) for 0 <= S <= 1/2, Z = S^2. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> AsinReduced(TReal<float, N> S, TReal<float, N> Z)
{
	return S * Z *
			   Polynomial(Z, 0.0336908475f, 0.0171492379f, 0.0311006624f, 0.0445994027f, 0.0750009418f, 0.166666657f) +
		   S;
}

template<int N>
TReal<float, N> Asin(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes A = Abs(X);
	const TMask<N> bUpper = A > FLanes(0.5f);
	const FLanes Z = Select(bUpper, (FLanes(1.0f) - A) * FLanes(0.5f), A * A);
	const FLanes P = AsinReduced(Select(bUpper, Sqrt(Z), A), Z);
	return CopySign(Select(bUpper, FLanes(HalfPiHigh) - (P + P - FLanes(HalfPiLow)), P), X);
}

template<int N>
TReal<float, N> Acos(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes A = Abs(X);
	const TMask<N> bUpper = A > FLanes(0.5f);
	const FLanes Z = Select(bUpper, (FLanes(1.0f) - A) * FLanes(0.5f), A * A);
	const FLanes P = AsinReduced(Select(bUpper, Sqrt(Z), A), Z);
	const FLanes Inner = FLanes(HalfPiHigh) - (CopySign(P, X) - FLanes(HalfPiLow));
	const FLanes Outer = Select(X < FLanes(0.0f), FLanes(2 * HalfPiHigh) - (P + P - FLanes(2 * HalfPiLow)), P + P);
	return Select(A <= FLanes(1.0f), Select(bUpper, Outer, Inner), FLanes(__builtin_nanf("")));
}

template<int N>
TReal<float, N> Sinh(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes A = Abs(X);
	const FLanes Z = A * A;
	const FLanes Near = A * Z * Polynomial(Z, 2.80628024e-06f, 0.000198381022f, 0.00833333936f, 0.166666672f) + A;
	const FLanes E = Exp(A);
	const FLanes Root = Exp(A * FLanes(0.5f)); // keeps the last half octave from overflowing
	const FLanes Middle = (E - FLanes(1.0f) / E) * FLanes(0.5f);
	const FLanes Far = Root * FLanes(0.5f) * Root;
	return CopySign(Select(A < FLanes(1.0f), Near, Select(A < FLanes(40.0f), Middle, Far)), X);
}

template<int N>
TReal<float, N> Cosh(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes A = Abs(X);
	const FLanes E = Exp(A);
	const FLanes Root = Exp(A * FLanes(0.5f));
	return Select(A < FLanes(40.0f), (E + FLanes(1.0f) / E) * FLanes(0.5f), Root * FLanes(0.5f) * Root);
}

template<int N>
TReal<float, N> Tanh(TReal<float, N> X)
{
	using FLanes = TReal<float, N>;
	const FLanes A = Abs(X);
	const FLanes Z = A * A;
	const FLanes Near =
		A * Z * Polynomial(Z, -0.00609671418f, 0.0209971797f, -0.0538509078f, 0.133327693f, -0.333333284f) + A;
	const FLanes Far = FLanes(1.0f) - FLanes(2.0f) / (Exp(A + A) + FLanes(1.0f));
	return CopySign(Select(A < FLanes(0.625f), Near, Far), X);
}

// Double: the C library.
#define DRYDOCK_LANES_LIBM(Name, Function) \
	template<int N> \
	inline TReal<double, N> Name(TReal<double, N> X) \
	{ \
		for (int Lane = 0; Lane < N; ++Lane) \
		{ \
			X.V[Lane] = __builtin_##Function(X.V[Lane]); \
		} \
		return X; \
	}
DRYDOCK_LANES_LIBM(Exp2, exp2)
DRYDOCK_LANES_LIBM(Exp, exp)
DRYDOCK_LANES_LIBM(Log2, log2)
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
#undef DRYDOCK_LANES_LIBM

template<int N>
inline TReal<double, N> Atan2(TReal<double, N> Y, TReal<double, N> X)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Y.V[Lane] = __builtin_atan2(X.V[Lane] < 0 ? Y.V[Lane] + 0.0 : Y.V[Lane], X.V[Lane]);
	}
	return Y;
}

} // namespace Impl

DRYDOCK_LANES_UNARY(Exp2, Impl::Exp2(x))
DRYDOCK_LANES_UNARY(Exp, Impl::Exp(x))
DRYDOCK_LANES_UNARY(Log2, Impl::Log2(x))
DRYDOCK_LANES_UNARY(Log, Impl::Log(x))
DRYDOCK_LANES_UNARY(Sin, Impl::Sin(x))
DRYDOCK_LANES_UNARY(Cos, Impl::Cos(x))
DRYDOCK_LANES_UNARY(Tan, Impl::Tan(x))
DRYDOCK_LANES_UNARY(Asin, Impl::Asin(x))
DRYDOCK_LANES_UNARY(Acos, Impl::Acos(x))
DRYDOCK_LANES_UNARY(Atan, Impl::Atan(x))
DRYDOCK_LANES_UNARY(Sinh, Impl::Sinh(x))
DRYDOCK_LANES_UNARY(Cosh, Impl::Cosh(x))
DRYDOCK_LANES_UNARY(Tanh, Impl::Tanh(x))
DRYDOCK_LANES_BINARY(Atan2, Impl::Atan2(x, y)) // y first, as in HLSL

namespace Impl
{

/** log(1 + X). The logarithm of the rounded sum is off by as much as the sum is: Kahan, "Branch cuts" (1987). */
template<CLanes T>
T LogOfOneMore(T X)
{
	const T Sum = T(1) + X;
	return Select(Sum == T(1), X, Log(Sum) * Select(X < T(0x1p60), X / (Sum - T(1)), T(1)));
}
/** Beyond these the square of the argument is all that counts. */
template<CLanes T>
T LogOfTwice(T X)
{
	return Log(X) + T(0.69314718055994531);
}
template<CLanes T>
T Asinh(T X)
{
	const T A = Abs(X);
	const T Near = LogOfOneMore(A + A * A / (T(1) + Sqrt(A * A + T(1))));
	return CopySign(Select(A < T(0x1p30), Near, LogOfTwice(A)), X);
}
template<CLanes T>
T Acosh(T X)
{
	const T A = X - T(1);
	return Select(X < T(0x1p30) || X != X, LogOfOneMore(A + Sqrt(A * (A + T(2)))), LogOfTwice(X));
}
template<CLanes T>
T Atanh(T X)
{
	const T A = Abs(X);
	return CopySign(T(0.5) * LogOfOneMore((A + A) / (T(1) - A)), X);
}

} // namespace Impl

DRYDOCK_LANES_UNARY(Asinh, Impl::Asinh(x))
DRYDOCK_LANES_UNARY(Acosh, Impl::Acosh(x))
DRYDOCK_LANES_UNARY(Atanh, Impl::Atanh(x))

/** The fraction of x, of 0.5 to below 1, and the power of two that makes x of it. Both are 0 for 0 and for what a float
 * flushes; infinities and NaN are their own fraction. */
template<CUniform T>
DRYDOCK_LANES_INLINE TVec<T, 2> Frexp(T X)
{
	const bool bFinite = X - X == T(0);
	int Exponent = 0;
	const T Fraction = T(__builtin_frexp(double(X), &Exponent));
	const bool bNormal = bFinite && !(__builtin_fabs(double(X)) < 0x1p-126);
	return bNormal ? TVec<T, 2>(Fraction, T(Exponent)) : TVec<T, 2>(bFinite ? X * T(0) : X, T(0));
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TVec<TReal<Real, N>, 2> Frexp(TReal<Real, N> X)
{
	TVec<TReal<Real, N>, 2> Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const TVec<Real, 2> One = Frexp(Real(X.V[Lane]));
		Result.E[0].V[Lane] = One.E[0];
		Result.E[1].V[Lane] = One.E[1];
	}
	return Result;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
