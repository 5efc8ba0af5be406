// The unsigned floats of R11G11B10 convert by definition: every pattern, every midpoint, the special values.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "PixelFormatConversion.h"

namespace
{

using namespace Drydock;

constexpr double GInfinity = std::numeric_limits<double>::infinity();
constexpr double GNaN = std::numeric_limits<double>::quiet_NaN();

/** Value of a finite pattern from the format's definition: bias 15, denormals below 2^-14. */
double DefinitionOf(uint32_t Bits, int32_t MantissaBits)
{
	const int32_t Exponent = int32_t(Bits >> MantissaBits);
	const double Fraction = std::ldexp(double(Bits & ((1u << MantissaBits) - 1)), -MantissaBits);
	return Exponent == 0 ? std::ldexp(Fraction, -14) : std::ldexp(1 + Fraction, Exponent - 15);
}

uint32_t EncodePacked(float R, float G, float B)
{
	const float RGBA[4] = {R, G, B, 1};
	uint32_t Packed;
	EncodeTexel(ETexelStorage::R11G11B10_FLOAT, RGBA, &Packed);
	return Packed;
}

class MiniFloat : public testing::TestWithParam<int32_t>
{
protected:
	const int32_t MantissaBits = GetParam();
	const uint32_t Infinity = 31u << MantissaBits;
	const uint32_t Quiet = 1u << (MantissaBits - 1);
};

} // namespace

TEST_P(MiniFloat, EveryFinitePatternIsItsDefinitionAndRoundTrips)
{
	for (uint32_t Bits = 0; Bits < Infinity; ++Bits)
	{
		ASSERT_EQ(DefinitionOf(Bits, MantissaBits), DecodeUnsignedMiniFloat(Bits, MantissaBits)) << Bits;
		ASSERT_EQ(Bits, EncodeUnsignedMiniFloat(DefinitionOf(Bits, MantissaBits), MantissaBits)) << Bits;
	}
}

TEST_P(MiniFloat, EveryMidpointTiesToEven)
{
	for (uint32_t Bits = 0; Bits + 1 < Infinity; ++Bits)
	{
		const double Midpoint = (DefinitionOf(Bits, MantissaBits) + DefinitionOf(Bits + 1, MantissaBits)) / 2;
		ASSERT_EQ(Bits + (Bits & 1), EncodeUnsignedMiniFloat(Midpoint, MantissaBits)) << Midpoint;
		ASSERT_EQ(Bits, EncodeUnsignedMiniFloat(std::nextafter(Midpoint, 0.0), MantissaBits)) << Midpoint;
		ASSERT_EQ(Bits + 1, EncodeUnsignedMiniFloat(std::nextafter(Midpoint, GInfinity), MantissaBits)) << Midpoint;
	}
}

TEST_P(MiniFloat, NaNPatternsStayNaNAndBecomeQuiet)
{
	for (uint32_t Bits = Infinity + 1; Bits < 32u << MantissaBits; ++Bits)
	{
		ASSERT_TRUE(std::isnan(DecodeUnsignedMiniFloat(Bits, MantissaBits))) << Bits;
		ASSERT_EQ(Bits | Quiet, EncodeUnsignedMiniFloat(DecodeUnsignedMiniFloat(Bits, MantissaBits), MantissaBits))
			<< Bits;
	}
}

TEST_P(MiniFloat, InfinityRoundTripsAndMinusInfinityIsZero)
{
	EXPECT_EQ(GInfinity, DecodeUnsignedMiniFloat(Infinity, MantissaBits));
	EXPECT_EQ(Infinity, EncodeUnsignedMiniFloat(GInfinity, MantissaBits));
	EXPECT_EQ(0u, EncodeUnsignedMiniFloat(-GInfinity, MantissaBits));
}

TEST_P(MiniFloat, FiniteOverflowIsTheLargestFiniteValue)
{
	EXPECT_EQ(Infinity - 1, EncodeUnsignedMiniFloat(65536.0, MantissaBits));
	EXPECT_EQ(Infinity - 1, EncodeUnsignedMiniFloat(1e300, MantissaBits));
}

TEST_P(MiniFloat, NegativeIsZeroNaNIsNaN)
{
	EXPECT_EQ(0u, EncodeUnsignedMiniFloat(-1e-30, MantissaBits));
	EXPECT_EQ(0u, EncodeUnsignedMiniFloat(-0.0, MantissaBits));
	EXPECT_EQ(Infinity | Quiet, EncodeUnsignedMiniFloat(GNaN, MantissaBits));
	EXPECT_EQ(Infinity | Quiet, EncodeUnsignedMiniFloat(-GNaN, MantissaBits));
}

INSTANTIATE_TEST_SUITE_P(ElevenAndTenBits, MiniFloat, testing::Values(6, 5));

TEST(R11G11B10, LargestValuesAreThePublishedOnes)
{
	EXPECT_EQ(65024.0, DecodeUnsignedMiniFloat((31u << 6) - 1, 6));
	EXPECT_EQ(64512.0, DecodeUnsignedMiniFloat((31u << 5) - 1, 5));
}

TEST(R11G11B10, ChannelsLieFromTheLowBitsUp)
{
	EXPECT_EQ(0x3c0u, EncodePacked(1, 0, 0));
	EXPECT_EQ(0x3c0u << 11, EncodePacked(0, 1, 0));
	EXPECT_EQ(0x1e0u << 22, EncodePacked(0, 0, 1));
}

TEST(R11G11B10, AlphaReadsAsOne)
{
	const uint32_t Packed = EncodePacked(0.5f, 0.25f, 2.0f);
	float RGBA[4];
	DecodeTexel(ETexelStorage::R11G11B10_FLOAT, &Packed, RGBA);
	EXPECT_EQ(0.5f, RGBA[0]);
	EXPECT_EQ(0.25f, RGBA[1]);
	EXPECT_EQ(2.0f, RGBA[2]);
	EXPECT_EQ(1.0f, RGBA[3]);
}

TEST(R11G11B10, BlueRoundsCoarserThanRed)
{
	const uint32_t Packed = EncodePacked(1 + 1 / 64.0f, 1, 1 + 1 / 64.0f); // a step of red, half a step of blue
	float RGBA[4];
	DecodeTexel(ETexelStorage::R11G11B10_FLOAT, &Packed, RGBA);
	EXPECT_EQ(1 + 1 / 64.0f, RGBA[0]);
	EXPECT_EQ(1.0f, RGBA[2]);
}
