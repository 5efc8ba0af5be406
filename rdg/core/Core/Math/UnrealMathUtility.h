// FMath: scalar mathematics under the engine's names, and its constants. Source: engine Math/UnrealMathUtility.h,
// GenericPlatform/GenericPlatformMath.h, Templates/AlignmentTemplates.h.
#pragma once

#include "Math/MathFwd.h"
#include "Misc/AssertionMacros.h"
#include "Math/NumericLimits.h"
#include "Math/ToInteger.h"

#include <bit>
#include <cmath>
#include <concepts>
#include <type_traits>

#define UE_PI (3.1415926535897932f)
#define UE_TWO_PI (6.2831853071795864f)
#define UE_HALF_PI (1.57079632679f)
#define UE_INV_PI (0.31830988618f)
#define UE_DOUBLE_PI (3.141592653589793238462643383279502884197169399)
#define UE_SMALL_NUMBER (1.e-8f)
#define UE_KINDA_SMALL_NUMBER (1.e-4f)
#define UE_BIG_NUMBER (3.4e+38f)
#define UE_DELTA (0.00001f)
#define UE_EULERS_NUMBER (2.71828182845904523536f)
#define UE_SQRT_2 (1.4142135623730950488016887242097f)
#define UE_GOLDEN_RATIO (1.6180339887498948482045868343656381f)
#ifndef PI
#define PI UE_PI
#endif
#define TWO_PI UE_TWO_PI
#define HALF_PI UE_HALF_PI
#define INV_PI UE_INV_PI
#define SMALL_NUMBER UE_SMALL_NUMBER
#define KINDA_SMALL_NUMBER UE_KINDA_SMALL_NUMBER
#define BIG_NUMBER UE_BIG_NUMBER
#define DELTA UE_DELTA

namespace Drydock::Private
{

/** float stays float; double and integers compute in double. */
template<typename T>
using TReal = std::conditional_t<std::is_same_v<T, float>, float, double>;

} // namespace Drydock::Private

struct FMath
{
	// Comparing. Mixed types meet in their common type. With a NaN, Min and Max return the second argument.
	template<typename A, typename B>
	static constexpr std::common_type_t<A, B> Max(const A& First, const B& Second)
	{
		using T = std::common_type_t<A, B>;
		return static_cast<T>(Second) < static_cast<T>(First) ? static_cast<T>(First) : static_cast<T>(Second);
	}
	template<typename A, typename B>
	static constexpr std::common_type_t<A, B> Min(const A& First, const B& Second)
	{
		using T = std::common_type_t<A, B>;
		return static_cast<T>(First) < static_cast<T>(Second) ? static_cast<T>(First) : static_cast<T>(Second);
	}
	template<typename T>
	static constexpr T Max3(const T& A, const std::type_identity_t<T>& B, const std::type_identity_t<T>& C)
	{
		return Max(Max(A, B), C);
	}
	template<typename T>
	static constexpr T Min3(const T& A, const std::type_identity_t<T>& B, const std::type_identity_t<T>& C)
	{
		return Min(Min(A, B), C);
	}
	template<typename T, typename A, typename B>
	static constexpr std::common_type_t<T, A, B> Clamp(const T& Value, const A& Low, const B& High)
	{
		return Max(Min(Value, High), Low);
	}
	/** Clamps to 0..1. */
	template<typename T>
	static constexpr T Saturate(const T& Value)
	{
		return Clamp(Value, T(0), T(1));
	}
	template<typename T>
	static constexpr T Abs(const T& Value)
	{
		return Value < T(0) ? T(-Value) : Value == T(0) ? T(0) : Value;
	}
	/** -1, 0 or 1. */
	template<typename T>
	static constexpr T Sign(const T& Value)
	{
		return Value > T(0) ? T(1) : Value < T(0) ? T(-1) : T(0);
	}
	static bool IsNearlyEqual(float A, float B, float Tolerance = UE_SMALL_NUMBER)
	{
		return std::fabs(A - B) <= Tolerance;
	}
	static bool IsNearlyEqual(double A, double B, double Tolerance = UE_SMALL_NUMBER)
	{
		return std::fabs(A - B) <= Tolerance;
	}
	static bool IsNearlyZero(float Value, float Tolerance = UE_SMALL_NUMBER) { return std::fabs(Value) <= Tolerance; }
	static bool IsNearlyZero(double Value, double Tolerance = UE_SMALL_NUMBER) { return std::fabs(Value) <= Tolerance; }
	static bool IsNaN(float Value) { return std::isnan(Value); }
	static bool IsNaN(double Value) { return std::isnan(Value); }
	static bool IsFinite(float Value) { return std::isfinite(Value); }
	static bool IsFinite(double Value) { return std::isfinite(Value); }
	template<typename T>
	static constexpr bool IsWithin(
		const T& Value, const std::type_identity_t<T>& Low, const std::type_identity_t<T>& High)
	{
		return Value >= Low && Value < High;
	}
	template<typename T>
	static constexpr bool IsWithinInclusive(
		const T& Value, const std::type_identity_t<T>& Low, const std::type_identity_t<T>& High)
	{
		return Value >= Low && Value <= High;
	}

	// Rounding. Results of float are int32, of double int64, as in the engine; halves go up. A value that the integer
	// cannot hold gives the nearest end, and NaN gives 0 (ToInteger.h), where the engine's result is the CPU's.
	static int32 TruncToInt(float Value) { return Drydock::ToInteger<int32>(Value); }
	static int64 TruncToInt(double Value) { return Drydock::ToInteger<int64>(Value); }
	static int32 FloorToInt(float Value) { return Drydock::ToInteger<int32>(std::floor(Value)); }
	static int64 FloorToInt(double Value) { return Drydock::ToInteger<int64>(std::floor(Value)); }
	static int32 CeilToInt(float Value) { return Drydock::ToInteger<int32>(std::ceil(Value)); }
	static int64 CeilToInt(double Value) { return Drydock::ToInteger<int64>(std::ceil(Value)); }
	static int32 RoundToInt(float Value) { return FloorToInt(Value + 0.5f); }
	static int64 RoundToInt(double Value) { return FloorToInt(Value + 0.5); }
	template<std::floating_point T>
	static int32 TruncToInt32(T Value)
	{
		return Drydock::ToInteger<int32>(Value);
	}
	template<std::floating_point T>
	static int32 FloorToInt32(T Value)
	{
		return Drydock::ToInteger<int32>(std::floor(Value));
	}
	template<std::floating_point T>
	static int32 CeilToInt32(T Value)
	{
		return Drydock::ToInteger<int32>(std::ceil(Value));
	}
	template<std::floating_point T>
	static int32 RoundToInt32(T Value)
	{
		return Drydock::ToInteger<int32>(std::floor(Value + T(0.5)));
	}
	static float TruncToFloat(float Value) { return std::trunc(Value); }
	static float FloorToFloat(float Value) { return std::floor(Value); }
	static float CeilToFloat(float Value) { return std::ceil(Value); }
	static float RoundToFloat(float Value) { return std::floor(Value + 0.5f); }
	static double FloorToDouble(double Value) { return std::floor(Value); }
	static double CeilToDouble(double Value) { return std::ceil(Value); }
	static double RoundToDouble(double Value) { return std::floor(Value + 0.5); }
	/** Value - floor(Value): never negative. */
	template<std::floating_point T>
	static T Frac(T Value)
	{
		return Value - std::floor(Value);
	}
	/** Value - trunc(Value): has the sign of Value. */
	template<std::floating_point T>
	static T Fractional(T Value)
	{
		return Value - std::trunc(Value);
	}
	template<typename A, typename B>
	static auto Fmod(A Value, B Divisor)
	{
		using T = Drydock::Private::TReal<std::common_type_t<A, B>>;
		return std::fmod(static_cast<T>(Value), static_cast<T>(Divisor));
	}
	template<std::floating_point T>
	static T GridSnap(T Value, std::type_identity_t<T> Grid)
	{
		return Grid == T(0) ? Value : std::floor((Value + Grid / T(2)) / Grid) * Grid;
	}

	// Whole numbers.
	template<typename T>
	static constexpr T DivideAndRoundUp(T Dividend, std::type_identity_t<T> Divisor)
	{
		return (Dividend + Divisor - 1) / Divisor;
	}
	template<typename T>
	static constexpr T DivideAndRoundDown(T Dividend, std::type_identity_t<T> Divisor)
	{
		return Dividend / Divisor;
	}
	template<typename T>
	static constexpr T DivideAndRoundNearest(T Dividend, std::type_identity_t<T> Divisor)
	{
		return Dividend >= 0 ? (Dividend + Divisor / 2) / Divisor : (Dividend - Divisor / 2 + 1) / Divisor;
	}
	template<std::integral T>
	static constexpr bool IsPowerOfTwo(T Value)
	{
		return (Value & (Value - 1)) == 0;
	}
	/** 0 and 1 give 1. */
	static constexpr uint32 RoundUpToPowerOfTwo(uint32 Value) { return 1u << CeilLogTwo(Value); }
	static constexpr uint64 RoundUpToPowerOfTwo64(uint64 Value) { return 1ull << CeilLogTwo64(Value); }
	static constexpr uint32 RoundDownToPowerOfTwo(uint32 Value) { return 1u << FloorLog2(Value); }
	/** 0 gives 0. */
	static constexpr uint32 FloorLog2(uint32 Value) { return Value == 0 ? 0 : std::bit_width(Value) - 1; }
	static constexpr uint64 FloorLog2_64(uint64 Value) { return Value == 0 ? 0 : std::bit_width(Value) - 1; }
	/** 0 and 1 give 0. */
	static constexpr uint32 CeilLogTwo(uint32 Value) { return Value <= 1 ? 0 : std::bit_width(Value - 1); }
	static constexpr uint64 CeilLogTwo64(uint64 Value) { return Value <= 1 ? 0 : std::bit_width(Value - 1); }
	static constexpr uint32 CountLeadingZeros(uint32 Value) { return std::countl_zero(Value); }
	static constexpr uint32 CountTrailingZeros(uint32 Value) { return std::countr_zero(Value); }
	static constexpr int32 CountBits(uint64 Value) { return std::popcount(Value); }

	// Powers and angles, in radians.
	template<typename T>
	static constexpr T Square(T Value)
	{
		return Value * Value;
	}
	template<typename T>
	static constexpr T Cube(T Value)
	{
		return Value * Value * Value;
	}
#define DRYDOCK_REAL_FUNCTION(Name, Function) \
	template<typename T> \
	static auto Name(T Value) \
	{ \
		return std::Function(static_cast<Drydock::Private::TReal<T>>(Value)); \
	}
	DRYDOCK_REAL_FUNCTION(Sqrt, sqrt)
	template<typename T>
	static auto InvSqrt(T Value)
	{
		return Drydock::Private::TReal<T>(1) / Sqrt(Value);
	}
	template<typename A, typename B>
	static auto Pow(A Base, B Exponent)
	{
		using T = Drydock::Private::TReal<std::common_type_t<A, B>>;
		return std::pow(static_cast<T>(Base), static_cast<T>(Exponent));
	}
	DRYDOCK_REAL_FUNCTION(Exp, exp)
	DRYDOCK_REAL_FUNCTION(Exp2, exp2)
	DRYDOCK_REAL_FUNCTION(Loge, log)
	DRYDOCK_REAL_FUNCTION(Log2, log2)
	template<typename A, typename B>
	static auto LogX(A Base, B Value)
	{
		return Loge(Value) / Loge(Base);
	}
	DRYDOCK_REAL_FUNCTION(Sin, sin)
	DRYDOCK_REAL_FUNCTION(Cos, cos)
	DRYDOCK_REAL_FUNCTION(Tan, tan)
	DRYDOCK_REAL_FUNCTION(Asin, asin)
	DRYDOCK_REAL_FUNCTION(Acos, acos)
	DRYDOCK_REAL_FUNCTION(Atan, atan)
	template<typename A, typename B>
	static auto Atan2(A Y, B X)
	{
		using T = Drydock::Private::TReal<std::common_type_t<A, B>>;
		return std::atan2(static_cast<T>(Y), static_cast<T>(X));
	}
	DRYDOCK_REAL_FUNCTION(Tanh, tanh)
#undef DRYDOCK_REAL_FUNCTION
	template<std::floating_point T>
	static void SinCos(T* OutSin, T* OutCos, std::type_identity_t<T> Value)
	{
		*OutSin = std::sin(Value);
		*OutCos = std::cos(Value);
	}
	template<typename T>
	static constexpr auto DegreesToRadians(T Degrees)
	{
		return Degrees * (Drydock::Private::TReal<T>(UE_DOUBLE_PI) / Drydock::Private::TReal<T>(180));
	}
	template<typename T>
	static constexpr auto RadiansToDegrees(T Radians)
	{
		return Radians * (Drydock::Private::TReal<T>(180) / Drydock::Private::TReal<T>(UE_DOUBLE_PI));
	}

	// Interpolation.
	template<typename T, typename U>
	static constexpr auto Lerp(const T& A, const std::type_identity_t<T>& B, const U& Alpha)
	{
		if constexpr (std::is_arithmetic_v<T>)
		{
			return static_cast<std::common_type_t<T, U>>(A + Alpha * (B - A));
		}
		else
		{
			return static_cast<T>(A + (B - A) * Alpha);
		}
	}
	/** Gives B exactly at Alpha 1. */
	template<std::floating_point T>
	static constexpr T LerpStable(T A, std::type_identity_t<T> B, std::type_identity_t<T> Alpha)
	{
		return A * (T(1) - Alpha) + B * Alpha;
	}
	/** 0 below A, 1 above B, a cubic between. */
	template<std::floating_point T>
	static constexpr T SmoothStep(T A, std::type_identity_t<T> B, std::type_identity_t<T> Value)
	{
		if (Value < A)
		{
			return T(0);
		}
		if (Value >= B)
		{
			return T(1);
		}
		const T Fraction = (Value - A) / (B - A);
		return Fraction * Fraction * (T(3) - T(2) * Fraction);
	}
	/** Position of Value between Low (0) and High (1), not clamped; an empty range gives 0 below High and 1 from it on.
	 */
	template<std::floating_point T>
	static constexpr T GetRangePct(T Low, std::type_identity_t<T> High, std::type_identity_t<T> Value)
	{
		return High == Low ? (Value >= High ? T(1) : T(0)) : (Value - Low) / (High - Low);
	}
	// Random numbers, each thread with its own sequence, which begins alike in every run. The engine's come from the C
	// library, and differ from platform to platform.
	/** From 0 to 2^31 - 1. */
	static DRYDOCK_API int32 Rand();
	static DRYDOCK_API void RandInit(int32 Seed);
	/** From 0 to below 1. */
	static DRYDOCK_API float FRand();
	/** The sequence of FRandomStream, from a seed that code sets; 0 at first. */
	static DRYDOCK_API void SRandInit(int32 Seed);
	static DRYDOCK_API float SRand();
	/** From 0 to below Count; 0 if Count is not above 0. */
	static DRYDOCK_API int32 RandHelper(int32 Count);
	/** From Min to Max, both possible. */
	static int32 RandRange(int32 Min, int32 Max)
	{
		return Min + RandHelper(Max - Min + 1);
	}
	static float RandRange(float Min, float Max)
	{
		return FRandRange(Min, Max);
	}
	static double RandRange(double Min, double Max)
	{
		return FRandRange(Min, Max);
	}
	static float FRandRange(float Min, float Max)
	{
		return Min + (Max - Min) * FRand();
	}
	template<typename A, typename B>
	requires(std::is_arithmetic_v<A>&& std::is_arithmetic_v<B> &&
			 !(std::is_floating_point_v<A> && std::is_same_v<A, B>)) static double FRandRange(A Min, B Max)
	{
		return FRandRange(static_cast<double>(Min), static_cast<double>(Max));
	}
	static double FRandRange(double Min, double Max)
	{
		return Min + (Max - Min) * static_cast<double>(FRand());
	}
	static bool RandBool()
	{
		return RandRange(0, 1) == 1;
	}
	/** A direction of length 1, all equally likely. */
	static DRYDOCK_API FVector VRand();
	/** The value moved by at most DeltaTime * Speed of its distance. */
	/** The place of Value in a range as a place in another; Unclamped goes on beyond the ends. */
	template<typename T>
	static T GetMappedRangeValueUnclamped(const UE::Math::TVector2<T>& InputRange,
		const UE::Math::TVector2<T>& OutputRange, std::type_identity_t<T> Value)
	{
		return Lerp(OutputRange.X, OutputRange.Y, GetRangePct(InputRange.X, InputRange.Y, Value));
	}
	template<typename T>
	static T GetMappedRangeValueClamped(const UE::Math::TVector2<T>& InputRange,
		const UE::Math::TVector2<T>& OutputRange, std::type_identity_t<T> Value)
	{
		return Lerp(OutputRange.X, OutputRange.Y, Saturate(GetRangePct(InputRange.X, InputRange.Y, Value)));
	}
	static double FInterpTo(double Current, double Target, double DeltaTime, double Speed)
	{
		return Speed <= 0.0 ? Target : Current + (Target - Current) * Clamp(DeltaTime * Speed, 0.0, 1.0);
	}
};

/** Up to the next multiple of Alignment, a power of two. */
template<std::integral T>
constexpr T Align(T Value, uint64 Alignment)
{
	return static_cast<T>((static_cast<uint64>(Value) + Alignment - 1) & ~(Alignment - 1));
}
template<std::integral T>
constexpr T AlignDown(T Value, uint64 Alignment)
{
	return static_cast<T>(static_cast<uint64>(Value) & ~(Alignment - 1));
}
template<std::integral T>
constexpr bool IsAligned(T Value, uint64 Alignment)
{
	return (static_cast<uint64>(Value) & (Alignment - 1)) == 0;
}
/** Up to the next multiple of Alignment, any positive number. */
template<std::integral T>
constexpr T AlignArbitrary(T Value, uint64 Alignment)
{
	return static_cast<T>((static_cast<uint64>(Value) + Alignment - 1) / Alignment * Alignment);
}
