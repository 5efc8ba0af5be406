// Conversions from floating numbers to integers have the stated result for every number, also inside FMath.
#include <gtest/gtest.h>

#include "CoreMinimal.h"
#include "Math/ToInteger.h"

#include <bit>
#include <cmath>
#include <random>

using namespace Drydock;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Inf = std::numeric_limits<float>::infinity();

/** By the 64 bits of mantissa of a long double, which hold every integer and every float and double between them. */
template<typename IntegerType, typename RealType>
IntegerType Expect(RealType Value)
{
	if (std::isnan(Value))
	{
		return 0;
	}
	const long double Least = std::numeric_limits<IntegerType>::min();
	const long double Most = std::numeric_limits<IntegerType>::max();
	return static_cast<IntegerType>(std::fmin(std::fmax(std::trunc(static_cast<long double>(Value)), Least), Most));
}

template<typename IntegerType>
void CheckRandomBits(uint64 Seed)
{
	std::mt19937_64 Random(Seed);
	for (int32 Index = 0; Index < 100'000; ++Index)
	{
		const uint64 Bits = Random();
		const float Single = std::bit_cast<float>(static_cast<uint32>(Bits));
		const double Double = std::bit_cast<double>(Bits);
		// Most bit patterns are far out of range or below 1: those around the ends by scale.
		const double Near = std::ldexp(static_cast<double>(static_cast<int64>(Bits)), -static_cast<int>(Bits % 64));
		ASSERT_EQ(Expect<IntegerType>(Single), ToInteger<IntegerType>(Single)) << Single;
		ASSERT_EQ(Expect<IntegerType>(Double), ToInteger<IntegerType>(Double)) << Double;
		ASSERT_EQ(Expect<IntegerType>(Near), ToInteger<IntegerType>(Near)) << Near;
	}
}

} // namespace

TEST(ToInteger, IsDefinedForEveryNumber)
{
	CheckRandomBits<int8>(1);
	CheckRandomBits<uint8>(2);
	CheckRandomBits<int32>(3);
	CheckRandomBits<uint32>(4);
	CheckRandomBits<int64>(5);
	CheckRandomBits<uint64>(6);
}

TEST(ToInteger, TakesTheNearestEndAtTheEnds)
{
	EXPECT_EQ(2147483647, ToInteger<int32>(2147483648.0));
	EXPECT_EQ(2147483647, ToInteger<int32>(2147483647.9));
	EXPECT_EQ(2147483646, ToInteger<int32>(2147483646.9));
	EXPECT_EQ(2147483520, ToInteger<int32>(std::nextafter(2147483648.0f, 0.0f)));
	EXPECT_EQ(std::numeric_limits<int32>::min(), ToInteger<int32>(-2147483648.0f));
	EXPECT_EQ(std::numeric_limits<int32>::min(), ToInteger<int32>(-2147483648.9));
	EXPECT_EQ(std::numeric_limits<int32>::min(), ToInteger<int32>(-Inf));
	EXPECT_EQ(std::numeric_limits<int64>::max(), ToInteger<int64>(9223372036854775808.0));
	EXPECT_EQ(0u, ToInteger<uint32>(-0.5f));
	EXPECT_EQ(0u, ToInteger<uint32>(-1e30f));
	EXPECT_EQ(0, ToInteger<int32>(NaN));
	EXPECT_EQ(0, ToInteger<int32>(-NaN));
}

TEST(ToInteger, AnIndexIsOneOfThose)
{
	for (const float Position : {NaN, -NaN, Inf, -Inf, 1e30f, -1e30f, 1e-40f, -1.0f, -0.9f, 0.0f, 4.9f, 5.0f, 6.5f})
	{
		for (const int32 Count : {1, 2, 5, 64, std::numeric_limits<int32>::max()})
		{
			const int32 Index = ToIndex(Position, Count);
			const double Wanted =
				std::isnan(Position)
					? 0.0
					: std::trunc(std::fmin(std::fmax(static_cast<double>(Position), 0.0), Count - 1.0));
			EXPECT_EQ(Wanted, static_cast<double>(Index)) << Position << " of " << Count;
		}
		EXPECT_EQ(0, ToIndex(Position, 0));
		EXPECT_EQ(0, ToIndex(Position, -3));
	}
}

TEST(ToInteger, ACountLiesBetweenItsBounds)
{
	EXPECT_EQ(1, ToCount(NaN, 1, 128));
	EXPECT_EQ(128, ToCount(Inf, 1, 128));
	EXPECT_EQ(1, ToCount(-Inf, 1, 128));
	EXPECT_EQ(17, ToCount(17.9f, 1, 128));
	EXPECT_EQ(128, ToCount(1e38, 1, 128));
}

TEST(Math, RoundsWhatNoIntegerHoldsToItsEnds)
{
	constexpr int32 Most32 = std::numeric_limits<int32>::max(), Least32 = std::numeric_limits<int32>::min();
	constexpr int64 Most64 = std::numeric_limits<int64>::max(), Least64 = std::numeric_limits<int64>::min();
	for (int32 (*const Round)(float) : {static_cast<int32 (*)(float)>(&FMath::TruncToInt), &FMath::FloorToInt,
			 &FMath::CeilToInt, &FMath::RoundToInt, &FMath::TruncToInt32<float>, &FMath::FloorToInt32<float>,
			 &FMath::CeilToInt32<float>, &FMath::RoundToInt32<float>})
	{
		EXPECT_EQ(Most32, Round(Inf));
		EXPECT_EQ(Most32, Round(1e20f));
		EXPECT_EQ(Least32, Round(-Inf));
		EXPECT_EQ(Least32, Round(-3e9f));
		EXPECT_EQ(0, Round(NaN));
	}
	for (int64 (*const Round)(double) :
		{static_cast<int64 (*)(double)>(&FMath::TruncToInt), &FMath::FloorToInt, &FMath::CeilToInt, &FMath::RoundToInt})
	{
		EXPECT_EQ(Most64, Round(1e300));
		EXPECT_EQ(Least64, Round(-1e300));
		EXPECT_EQ(0, Round(static_cast<double>(NaN)));
	}
	EXPECT_EQ(Most32, FMath::CeilToInt32(1e300));
	EXPECT_EQ(FIntPoint(Least32, 0), FIntPoint(FVector2D(-1e20, static_cast<double>(NaN))));
	EXPECT_EQ(FIntRect(Least32, 0, Most32, 0), FIntRect(-1, 0, 1, 0).Scale(1e20));
}
