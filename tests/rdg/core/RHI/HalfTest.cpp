// Half conversion agrees with Imath and with its definition: every pattern, every midpoint.
#include <Imath/half.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "PixelFormatConversion.h"

namespace
{

using namespace Drydock;

constexpr double GInfinity = std::numeric_limits<double>::infinity();
constexpr uint32_t GLargestFinite = 0x7bff;

bool IsNaNPattern(uint32_t Bits)
{
	return (Bits & 0x7c00) == 0x7c00 && (Bits & 0x3ff) != 0;
}

float ImathDecode(uint32_t Bits)
{
	Imath::half Half;
	Half.setBits(uint16_t(Bits));
	return float(Half);
}

/** The magnitude of a pattern from the definition of binary16, also one step past the largest finite value. */
double DefinitionOf(uint32_t Magnitude)
{
	const int32_t Exponent = int32_t(Magnitude >> 10);
	const double Mantissa = Magnitude & 0x3ff;
	return Exponent == 0 ? std::ldexp(Mantissa, -24) : std::ldexp(1024 + Mantissa, Exponent - 25);
}

uint32_t EncodeThroughTexel(float Value)
{
	const float RGBA[4] = {Value, 0, 0, 0};
	uint16_t Bits;
	EncodeTexel(ETexelStorage::R16_FLOAT, RGBA, &Bits);
	return Bits;
}

} // namespace

TEST(Half, DecodesEveryPatternAsImath)
{
	for (uint32_t Bits = 0; Bits < 65536; ++Bits)
	{
		if (!IsNaNPattern(Bits))
		{
			ASSERT_EQ(
				std::bit_cast<uint32_t>(ImathDecode(Bits)), std::bit_cast<uint32_t>(float(DecodeHalf(uint16_t(Bits)))))
				<< Bits;
		}
	}
}

TEST(Half, ReencodesEveryPatternIdentically)
{
	for (uint32_t Bits = 0; Bits < 65536; ++Bits)
	{
		if (!IsNaNPattern(Bits))
		{
			ASSERT_EQ(Bits, EncodeHalf(DecodeHalf(uint16_t(Bits)))) << Bits;
		}
	}
}

TEST(Half, NaNsBecomeQuietAndKeepSignAndPayload)
{
	for (uint32_t Bits = 0; Bits < 65536; ++Bits)
	{
		if (IsNaNPattern(Bits))
		{
			ASSERT_TRUE(std::isnan(DecodeHalf(uint16_t(Bits)))) << Bits;
			ASSERT_EQ(Bits | 0x200, EncodeHalf(DecodeHalf(uint16_t(Bits)))) << Bits;
		}
	}
}

TEST(Half, EncodesAroundEveryMidpointAsImath)
{
	for (uint32_t Bits = 0; Bits < GLargestFinite; ++Bits)
	{
		const float Midpoint = float((DefinitionOf(Bits) + DefinitionOf(Bits + 1)) / 2);
		for (float Value : {std::nextafter(Midpoint, 0.0f), Midpoint, std::nextafter(Midpoint, 1e9f)})
		{
			ASSERT_EQ(Imath::half(Value).bits(), EncodeThroughTexel(Value)) << Value;
			ASSERT_EQ(Imath::half(-Value).bits(), EncodeThroughTexel(-Value)) << -Value;
		}
	}
}

TEST(Half, MidpointsTieToEvenAndDoublesBesideThemDoNot)
{
	for (uint32_t Bits = 0; Bits < GLargestFinite; ++Bits)
	{
		const double Midpoint = (DefinitionOf(Bits) + DefinitionOf(Bits + 1)) / 2;
		ASSERT_EQ(Bits + (Bits & 1), EncodeHalf(Midpoint)) << Midpoint;
		ASSERT_EQ(Bits, EncodeHalf(std::nextafter(Midpoint, 0.0))) << Midpoint;
		ASSERT_EQ(Bits + 1, EncodeHalf(std::nextafter(Midpoint, GInfinity))) << Midpoint;
	}
}

TEST(Half, ADoubleIsRoundedOnceNotThroughFloat)
{
	const double JustAboveTie = 1 + std::ldexp(1.0, -11) + std::ldexp(1.0, -40);
	ASSERT_EQ(Imath::half(1.0f).bits(), Imath::half(float(JustAboveTie)).bits()); // through float it is a tie, to even
	EXPECT_EQ(0x3c01, EncodeHalf(JustAboveTie));
}

TEST(Half, FiniteOverflowBecomesInfinityFrom65520)
{
	EXPECT_EQ(0x7bff, EncodeHalf(std::nextafter(65520.0, 0.0)));
	EXPECT_EQ(0x7c00, EncodeHalf(65520.0));
	EXPECT_EQ(0xfc00, EncodeHalf(-65520.0));
	EXPECT_EQ(0x7c00, EncodeHalf(1e300));
}

TEST(Half, SaturationStopsFiniteValuesAndLeavesInfinity)
{
	EXPECT_EQ(0x7bff, EncodeHalf(65520.0, true));
	EXPECT_EQ(0xfbff, EncodeHalf(-1e300, true));
	EXPECT_EQ(0x7c00, EncodeHalf(GInfinity, true));
	EXPECT_EQ(0xfc00, EncodeHalf(-GInfinity, true));
	EXPECT_EQ(0x7e00, EncodeHalf(std::numeric_limits<double>::quiet_NaN(), true));
}

TEST(Half, KeepsTheSignOfZeroAndOfWhatVanishes)
{
	EXPECT_EQ(0x8000, EncodeHalf(-0.0));
	EXPECT_EQ(0x8000, EncodeHalf(-1e-300));
	EXPECT_EQ(0x0000, EncodeHalf(std::ldexp(1.0, -25)));
	EXPECT_EQ(0x0001, EncodeHalf(std::nextafter(std::ldexp(1.0, -25), 1.0)));
}
