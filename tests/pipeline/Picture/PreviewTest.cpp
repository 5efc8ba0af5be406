// final.png of pictures for other devices than an sRGB display.
#include <gtest/gtest.h>

#include "Picture/Preview.h"

#include <cmath>

using namespace Drydock;

namespace
{

double Preview(double Value, EDisplayOutputFormat Device, int Channel = 0)
{
	return MakeDisplayColor({Value, Value, Value}, Device)[static_cast<size_t>(Channel)];
}

} // namespace

TEST(DisplayColor, SrgbIsAsItIs)
{
	EXPECT_EQ(0.3, Preview(0.3, EDisplayOutputFormat::SDR_sRGB));
}

TEST(DisplayColor, HundredNitsAreWhite)
{
	// ST 2084 of 100 nits is 0.508078; scRGB counts 80 nits as 1.
	EXPECT_NEAR(1.0, Preview(0.508078, EDisplayOutputFormat::HDR_ACES_1000nit_ST2084), 1e-4);
	EXPECT_NEAR(1.0, Preview(1.25, EDisplayOutputFormat::HDR_ACES_1000nit_ScRGB), 1e-9);
	EXPECT_NEAR(1.0, Preview(1.0, EDisplayOutputFormat::HDR_ACES_1000nit_ST2084, 2), 1e-12);
}

TEST(DisplayColor, LinearLightIsEncodedAndCutOff)
{
	EXPECT_NEAR(1.055 * std::pow(0.18, 1 / 2.4) - 0.055, Preview(0.18, EDisplayOutputFormat::HDR_LinearEXR), 1e-12);
	EXPECT_NEAR(1.0, Preview(7.0, EDisplayOutputFormat::HDR_LinearNoToneCurve), 1e-12);
}

TEST(DisplayColor, Rec709IsDecoded)
{
	// The same light: 0.18 is 0.409008 on BT.709's curve, 0.461356 on sRGB's.
	EXPECT_NEAR(0.461356, Preview(0.409008, EDisplayOutputFormat::SDR_Rec709), 1e-5);
}
