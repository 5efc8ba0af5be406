// The maths of the engine's geometry module for one type of number: FMathf and FMathd. Source: engine file MathUtil.h
// (GeometryCore).
#pragma once

#include "Math/UnrealMathUtility.h"

#include <cmath>
#include <limits>

/** Angles are in radians unless a function's name contains "degrees". */
template<typename RealType>
class TMathUtil
{
public:
	static constexpr RealType Epsilon = std::numeric_limits<RealType>::epsilon();
	static constexpr RealType ZeroTolerance = sizeof(RealType) == sizeof(float) ? RealType(1e-06) : RealType(1e-08);
	static constexpr RealType MaxReal = std::numeric_limits<RealType>::max();
	static constexpr RealType Pi = RealType(UE_DOUBLE_PI);
	static constexpr RealType TwoPi = RealType(2 * UE_DOUBLE_PI);
	static constexpr RealType FourPi = RealType(4 * UE_DOUBLE_PI);
	static constexpr RealType HalfPi = RealType(UE_DOUBLE_PI / 2);
	static constexpr RealType InvPi = RealType(1 / UE_DOUBLE_PI);
	static constexpr RealType InvTwoPi = RealType(1 / (2 * UE_DOUBLE_PI));
	static constexpr RealType DegToRad = RealType(UE_DOUBLE_PI / 180);
	static constexpr RealType RadToDeg = RealType(180 / UE_DOUBLE_PI);

	static bool IsNaN(RealType Value) { return std::isnan(Value); }
	static bool IsFinite(RealType Value) { return std::isfinite(Value); }
	static RealType Abs(RealType Value) { return std::abs(Value); }
	static RealType Clamp(RealType Value, RealType Least, RealType Most) { return FMath::Clamp(Value, Least, Most); }
	/** -1, 0 or 1. */
	static RealType Sign(RealType Value) { return RealType(Value > 0) - RealType(Value < 0); }
	static RealType SignNonZero(RealType Value) { return Value < 0 ? RealType(-1) : RealType(1); }
	static RealType Max(RealType A, RealType B) { return A >= B ? A : B; }
	static RealType Max3(RealType A, RealType B, RealType C) { return Max(Max(A, B), C); }
	static RealType Min(RealType A, RealType B) { return A <= B ? A : B; }
	static RealType Min3(RealType A, RealType B, RealType C) { return Min(Min(A, B), C); }
	static RealType Sqrt(RealType Value) { return std::sqrt(Value); }
	static RealType Cbrt(RealType Value) { return std::cbrt(Value); }
	static RealType Atan2(RealType Y, RealType X) { return std::atan2(Y, X); }
	/** 0 to two pi. */
	static RealType Atan2Positive(RealType Y, RealType X)
	{
		const RealType Angle = std::atan2(Y, X);
		return Angle < 0 ? Angle + TwoPi : Angle;
	}
	static RealType Sin(RealType Value) { return std::sin(Value); }
	static RealType Cos(RealType Value) { return std::cos(Value); }
	static RealType Tan(RealType Value) { return std::tan(Value); }
	static RealType ACos(RealType Value) { return std::acos(Value); }
	static RealType ASin(RealType Value) { return std::asin(Value); }
	static RealType ATan(RealType Value) { return std::atan(Value); }
	static RealType Floor(RealType Value) { return std::floor(Value); }
	static RealType Ceil(RealType Value) { return std::ceil(Value); }
	static RealType Pow(RealType Value, RealType Power) { return std::pow(Value, Power); }
	static RealType Exp(RealType Power) { return std::exp(Power); }
	static RealType Log(RealType Value) { return std::log(Value); }
	/** A at 0, B at 1. */
	static RealType Lerp(RealType A, RealType B, RealType Alpha) { return (1 - Alpha) * A + Alpha * B; }
	static RealType RoundHalfAwayFromZero(RealType Value) { return std::round(Value); }
	/** Length of the vector. */
	static RealType Hypot(RealType X, RealType Y) { return std::hypot(X, Y); }
};

using FMathf = TMathUtil<float>;
using FMathd = TMathUtil<double>;
