// UNORM, sRGB and UINT values convert by definition.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "PixelFormatConversion.h"

namespace
{

using namespace Drydock;

constexpr double GInfinity = std::numeric_limits<double>::infinity();
constexpr double GNaN = std::numeric_limits<double>::quiet_NaN();

class Unorm : public testing::TestWithParam<int32_t>
{
protected:
	const int32_t Bits = GetParam();
	const uint32_t Max = (1u << Bits) - 1;
};

long double SrgbToLinear(long double Encoded)
{
	return Encoded <= 0.04045L ? Encoded / 12.92L : powl((Encoded + 0.055L) / 1.055L, 2.4L);
}

} // namespace

TEST_P(Unorm, EveryCodeRoundTripsThroughDoubleAndFloat)
{
	for (uint32_t Code = 0; Code <= Max; ++Code)
	{
		ASSERT_EQ(Code, EncodeUnorm(DecodeUnorm(Code, Bits), Bits));
		ASSERT_EQ(Code, EncodeUnorm(float(Code) / float(Max), Bits));
	}
}

TEST_P(Unorm, EveryCodeDecodesToTheNearestReal)
{
	for (uint32_t Code = 0; Code <= Max; ++Code)
	{
		const double Value = DecodeUnorm(Code, Bits);
		const auto Miss = [&](double Candidate)
		{
			return std::abs(std::fma(Candidate, double(Max), -double(Code)));
		};
		ASSERT_LE(Miss(Value), Miss(std::nextafter(Value, -1.0))) << Code;
		ASSERT_LE(Miss(Value), Miss(std::nextafter(Value, 2.0))) << Code;
		ASSERT_EQ(float(Code) / float(Max), float(Value)) << Code;
	}
}

TEST_P(Unorm, RoundsAtEveryMidpoint)
{
	for (uint32_t Code = 0; Code < Max; ++Code)
	{
		// Only a half is a double on a midpoint; the doubles on either side of the others round apart.
		const double Midpoint = double((Code + 0.5L) / Max);
		const double Below = std::nextafter(Midpoint, 0.0);
		const double Above = std::nextafter(Midpoint, 1.0);
		ASSERT_EQ(Code, EncodeUnorm(Below, Bits)) << Code;
		ASSERT_EQ(Code + 1, EncodeUnorm(Above, Bits)) << Code;
	}
}

TEST_P(Unorm, TheTieAtAHalfGoesToEven)
{
	EXPECT_EQ((Max + 1) / 2, EncodeUnorm(0.5, Bits)); // Max is odd, so half of it lies between (Max-1)/2, odd, and this
}

TEST_P(Unorm, ClampsAndTakesNaNAsZero)
{
	EXPECT_EQ(0u, EncodeUnorm(GNaN, Bits));
	EXPECT_EQ(0u, EncodeUnorm(-0.25, Bits));
	EXPECT_EQ(0u, EncodeUnorm(-GInfinity, Bits));
	EXPECT_EQ(Max, EncodeUnorm(1.5, Bits));
	EXPECT_EQ(Max, EncodeUnorm(GInfinity, Bits));
	EXPECT_EQ(0u, EncodeUnorm(std::numeric_limits<double>::denorm_min(), Bits));
}

INSTANTIATE_TEST_SUITE_P(Widths, Unorm, testing::Values(2, 8, 10, 16));

TEST(Unorm8, ADoubleIsRoundedOnce)
{
	const double JustAboveTie = 127.5 / 255 + std::ldexp(1.0, -53);
	ASSERT_EQ(0.5f, float(JustAboveTie));
	const double JustBelowTie = std::nextafter(0.5, 0.0);
	EXPECT_EQ(128u, EncodeUnorm(JustAboveTie, 8));
	EXPECT_EQ(127u, EncodeUnorm(JustBelowTie, 8));
}

TEST(Srgb8, EveryCodeIsTheFormulaAndRoundTrips)
{
	for (int32_t Code = 0; Code < 256; ++Code)
	{
		ASSERT_EQ(double(SrgbToLinear(Code / 255.0L)), DecodeSrgb8(uint8_t(Code))) << Code;
		ASSERT_EQ(Code, EncodeSrgb8(DecodeSrgb8(uint8_t(Code)))) << Code;
	}
}

TEST(Srgb8, EveryThresholdSeparatesNeighbouringDoubles)
{
	for (int32_t Code = 0; Code < 255; ++Code)
	{
		const double Threshold = double(SrgbToLinear((Code + 0.5L) / 255.0L));
		ASSERT_EQ(Code, EncodeSrgb8(std::nextafter(Threshold, 0.0))) << Code;
		ASSERT_EQ(Code + 1, EncodeSrgb8(std::nextafter(Threshold, 1.0))) << Code;
	}
}

TEST(Srgb8, AgreesWithTheEncodingFormulaAwayFromThresholds)
{
	for (int32_t Step = 0; Step <= 10000; ++Step)
	{
		const double Linear = Step / 10000.0;
		const double Encoded = 255 * (Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1 / 2.4) - 0.055);
		if (std::abs(Encoded - std::floor(Encoded) - 0.5) >
			1e-4) // the two halves of the standard's curve meet only to 1e-5
		{
			ASSERT_EQ(int32_t(std::lround(Encoded)), EncodeSrgb8(Linear)) << Linear;
		}
	}
}

TEST(Srgb8, ClampsAndTakesNaNAsZero)
{
	EXPECT_EQ(0, EncodeSrgb8(GNaN));
	EXPECT_EQ(0, EncodeSrgb8(-1));
	EXPECT_EQ(255, EncodeSrgb8(GInfinity));
}

TEST(Srgb8, AlphaStaysLinear)
{
	const float RGBA[4] = {0.5f, 0.5f, 0.5f, 0.5f};
	uint8_t Texel[4];
	EncodeTexel(ETexelStorage::BGRA8_SRGB, RGBA, Texel);
	EXPECT_EQ(188, Texel[0]);
	EXPECT_EQ(128, Texel[3]);
}

TEST(TexelOrder, BgraSwapsRedAndBlue)
{
	const float RGBA[4] = {1.0f, 0.0f, 0.2f, 0.4f};
	uint8_t Texel[4];
	EncodeTexel(ETexelStorage::BGRA8_UNORM, RGBA, Texel);
	EXPECT_EQ(51, Texel[0]);
	EXPECT_EQ(0, Texel[1]);
	EXPECT_EQ(255, Texel[2]);
	EXPECT_EQ(102, Texel[3]);
}

TEST(TexelOrder, TenTenTenTwoPacksFromTheLowBitsUp)
{
	const float RGBA[4] = {1.0f, 0.0f, 1.0f, 1 / 3.0f};
	uint32_t Packed;
	EncodeTexel(ETexelStorage::RGB10A2_UNORM, RGBA, &Packed);
	EXPECT_EQ(0x3ffu | (0x3ffu << 20) | (1u << 30), Packed);
}

TEST(TexelOrder, MissingChannelsReadZeroAndAlphaOne)
{
	const uint8_t Texel[2] = {255, 51};
	double RGBA[4];
	DecodeTexel(ETexelStorage::RG8_UNORM, Texel, RGBA);
	EXPECT_EQ(1.0, RGBA[0]);
	EXPECT_EQ(0.2, RGBA[1]);
	EXPECT_EQ(0.0, RGBA[2]);
	EXPECT_EQ(1.0, RGBA[3]);
}

TEST(Uint, RealsAreTruncatedAndSaturated)
{
	const float RGBA[4] = {-3.5f, 2.9f, 300.0f, NAN};
	uint8_t Texel[4];
	EncodeTexel(ETexelStorage::RGBA8_UINT, RGBA, Texel);
	EXPECT_EQ(0, Texel[0]);
	EXPECT_EQ(2, Texel[1]);
	EXPECT_EQ(255, Texel[2]);
	EXPECT_EQ(0, Texel[3]);
}

TEST(Uint, TheLargest32BitValueSurvivesFloat)
{
	const float RGBA[4] = {1e30f, 0, 0, 0};
	uint32_t Texel;
	EncodeTexel(ETexelStorage::R32_UINT, RGBA, &Texel);
	EXPECT_EQ(0xffffffffu, Texel);
}

TEST(Uint, IntegersAreVerbatimWhereTheyFit)
{
	const uint32_t RGBA[4] = {0xdeadbeefu, 1, 0x80000000u, 7};
	uint32_t Texel[4];
	uint32_t Out[4];
	EncodeTexel(ETexelStorage::RGBA32_UINT, RGBA, Texel);
	DecodeTexel(ETexelStorage::RGBA32_UINT, Texel, Out);
	EXPECT_EQ(0xdeadbeefu, Out[0]);
	EXPECT_EQ(1u, Out[1]);
	EXPECT_EQ(0x80000000u, Out[2]);
	EXPECT_EQ(7u, Out[3]);
}

TEST(Uint, IntegersBeyondTheRangeBecomeTheLargest)
{
	const uint32_t RGBA[4] = {70000, 5, 0, 0};
	uint16_t Texel[2];
	EncodeTexel(ETexelStorage::RG16_UINT, RGBA, Texel);
	EXPECT_EQ(65535, Texel[0]);
	EXPECT_EQ(5, Texel[1]);
}

TEST(Sint, NumbersOfEitherSignAreKept)
{
	for (const double Value : {-2147483648.0, -5.0, 0.0, 7.0, 2147483647.0})
	{
		const double RGBA[4] = {Value, 0, 0, 0};
		int32_t Texel = 1;
		double Out[4];
		EncodeTexel(ETexelStorage::R32_SINT, RGBA, &Texel);
		EXPECT_EQ(Value, Texel);
		DecodeTexel(ETexelStorage::R32_SINT, &Texel, Out);
		EXPECT_EQ(Value, Out[0]);
	}
	for (const auto& [Value, Expected] :
		{std::pair(-1e10, INT32_MIN), std::pair(1e10, INT32_MAX), std::pair(std::nan(""), 0)})
	{
		const double RGBA[4] = {Value, 0, 0, 0};
		int32_t Texel = 1;
		EncodeTexel(ETexelStorage::R32_SINT, RGBA, &Texel);
		EXPECT_EQ(Expected, Texel);
	}
}

TEST(TexelStorage, BytesPerTexelIsWhatIsWritten)
{
	for (int32_t Storage = 0; Storage < int32_t(ETexelStorage::Count); ++Storage)
	{
		uint8_t Texel[40];
		std::fill(std::begin(Texel), std::end(Texel), uint8_t(0xaa));
		const float RGBA[4] = {1, 1, 1, 1};
		EncodeTexel(ETexelStorage(Storage), RGBA, Texel);
		const int32_t Bytes = GetTexelStorageInfo(ETexelStorage(Storage)).BytesPerTexel;
		EXPECT_EQ(0xaa, Texel[Bytes]) << Storage;
		EXPECT_NE(0xaa, Texel[Bytes - 1]) << Storage;
	}
}

TEST(TexelStorage, EveryStorageReturnsOnesInItsChannels)
{
	for (int32_t Storage = 0; Storage < int32_t(ETexelStorage::Count); ++Storage)
	{
		const double Ones[4] = {1, 1, 1, 1};
		uint8_t Texel[32];
		double Out[4];
		EncodeTexel(ETexelStorage(Storage), Ones, Texel);
		DecodeTexel(ETexelStorage(Storage), Texel, Out);
		const int32_t NumChannels = GetTexelStorageInfo(ETexelStorage(Storage)).NumChannels;
		for (int32_t Channel = 0; Channel < 4; ++Channel)
		{
			EXPECT_EQ(Channel < NumChannels || Channel == 3 ? 1.0 : 0.0, Out[Channel]) << Storage << " " << Channel;
		}
	}
}

TEST(TexelStorage, SixtyFourBitTexelsKeepDoubles)
{
	const double RGBA[4] = {0.1, -1e-300, 1e300, 1.0 / 3};
	double Texel[4];
	EncodeTexel(ETexelStorage::RGBA64_FLOAT, RGBA, Texel);
	EXPECT_EQ(0.1, Texel[0]);
	EXPECT_EQ(-1e-300, Texel[1]);
	EXPECT_EQ(1e300, Texel[2]);
	EXPECT_EQ(1.0 / 3, Texel[3]);
}

TEST(TexelStorage, WideningKeepsTheChannelCount)
{
	EXPECT_EQ(ETexelStorage::RGB32_FLOAT, WidenTexelStorage(ETexelStorage::R11G11B10_FLOAT, false));
	EXPECT_EQ(ETexelStorage::RGBA64_FLOAT, WidenTexelStorage(ETexelStorage::RGB10A2_UNORM, true));
	EXPECT_EQ(ETexelStorage::R32_FLOAT, WidenTexelStorage(ETexelStorage::R8_UNORM, false));
	EXPECT_EQ(ETexelStorage::RG64_FLOAT, WidenTexelStorage(ETexelStorage::RG32_FLOAT, true));
}

TEST(TexelStorage, WideningLeavesIntegersAlone)
{
	EXPECT_EQ(ETexelStorage::R8_UINT, WidenTexelStorage(ETexelStorage::R8_UINT, false));
	EXPECT_EQ(ETexelStorage::RGBA32_UINT, WidenTexelStorage(ETexelStorage::RGBA32_UINT, true));
}
