// White balance against published white points, and how global and range values combine.
#include <gtest/gtest.h>

#include "ToneReference.h"

#include "Tonemap/ColorGrading.h"

#include <functional>

using namespace Drydock;

namespace
{

ToneReference::FVec Apply(const FColorMatrix& M, const ToneReference::FVec& Color)
{
	return ToneReference::Mul(M, Color);
}

/** Chromaticity of a linear Rec.709 colour. */
ToneReference::FChromaticity GetChromaticity(const ToneReference::FVec& Color)
{
	const ToneReference::FVec XYZ = ToneReference::Mul(ToneReference::Matrices().Rec709, Color);
	const double Sum = XYZ[0] + XYZ[1] + XYZ[2];
	return {XYZ[0] / Sum, XYZ[1] / Sum};
}

ToneReference::FVec WhiteAt(double Temperature, double Tint = 0.0)
{
	return Apply(ComputeWhiteBalance(Temperature, Tint, TEMP_ColorTemperature), {1, 1, 1});
}

} // namespace

TEST(WhiteBalance, NeutralIsExactlyTheIdentity)
{
	const FColorMatrix Identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
	EXPECT_EQ(Identity, ComputeWhiteBalance(6500, 0, TEMP_WhiteBalance));
	EXPECT_EQ(Identity, ComputeWhiteBalance(6500, 0, TEMP_ColorTemperature));
}

TEST(WhiteBalance, AColourTemperatureTurnsWhiteIntoThePublishedLight)
{
	// CIE 15: D50 has 5003 K and (0.3457, 0.3585), D55 5503 K and (0.3324, 0.3474), D75 7504 K and (0.2990, 0.3149).
	const double Published[][3] = {{5000, 0.3457, 0.3585}, {5500, 0.3324, 0.3474}, {7500, 0.2990, 0.3149}};
	for (const auto& [Temperature, X, Y] : Published)
	{
		const ToneReference::FChromaticity White = GetChromaticity(WhiteAt(Temperature));
		EXPECT_NEAR(X, White.X, 3e-4) << Temperature;
		EXPECT_NEAR(Y, White.Y, 3e-4) << Temperature;
	}
}

TEST(WhiteBalance, BelowFourThousandTheLightIsABlackBody)
{
	// Illuminant A, 2856 K: (0.44758, 0.40745).
	const ToneReference::FChromaticity White = GetChromaticity(WhiteAt(2856));
	EXPECT_NEAR(0.44758, White.X, 5e-4);
	EXPECT_NEAR(0.40745, White.Y, 5e-4);
}

TEST(WhiteBalance, BalancingALightMakesItWhite)
{
	for (const double Temperature : {2000.0, 3500.0, 5200.0, 12000.0})
	{
		const ToneReference::FVec White =
			Apply(ComputeWhiteBalance(Temperature, 0.3, TEMP_WhiteBalance), WhiteAt(Temperature, 0.3));
		for (const double Channel : White)
		{
			EXPECT_NEAR(1.0, Channel, 1e-6) << Temperature;
		}
	}
}

TEST(WhiteBalance, LowTemperaturesAreWarmLight)
{
	const ToneReference::FVec Warm = WhiteAt(3000), Cold = WhiteAt(10000);
	EXPECT_GT(Warm[0], Warm[2] * 1.5);
	EXPECT_GT(Cold[2], Cold[0] * 1.2);
}

TEST(WhiteBalance, TintMovesAcrossTheTemperature)
{
	// 0.05 in CIE 1960 for 1: u = 4x / (-2x + 12y + 3), v = 6y / (-2x + 12y + 3). Measured at the black body of 3000 K.
	const auto ToUV = [](const ToneReference::FChromaticity& C)
	{
		const double D = -2 * C.X + 12 * C.Y + 3;
		return std::array<double, 2>{4 * C.X / D, 6 * C.Y / D};
	};
	const std::array<double, 2> Plain = ToUV(GetChromaticity(WhiteAt(3000)));
	const std::array<double, 2> Tinted = ToUV(GetChromaticity(WhiteAt(3000, 1)));
	EXPECT_NEAR(0.05, std::hypot(Tinted[0] - Plain[0], Tinted[1] - Plain[1]), 1e-6);
	EXPECT_LT(Tinted[1], Plain[1]); // magenta lies below the black bodies
}

TEST(WhiteBalance, TemperaturesOutsideItsRangeAreKeptInIt)
{
	EXPECT_EQ(ComputeWhiteBalance(1500, 0, TEMP_WhiteBalance), ComputeWhiteBalance(0, 0, TEMP_WhiteBalance));
	EXPECT_EQ(ComputeWhiteBalance(15000, 0, TEMP_WhiteBalance), ComputeWhiteBalance(1e9, 0, TEMP_WhiteBalance));
}

TEST(ColorGrading, DefaultsAreNeutral)
{
	EXPECT_TRUE(MakeColorGrading(FPostProcessSettings()).bNeutral);
}

TEST(ColorGrading, AnyOneSettingMakesItNotNeutral)
{
	const std::function<void(FPostProcessSettings&)> Changes[] = {[](FPostProcessSettings& S) { S.WhiteTemp = 6501; },
		[](FPostProcessSettings& S) { S.WhiteTint = 0.01f; },
		[](FPostProcessSettings& S) { S.ColorSaturation.W = 0.9; },
		[](FPostProcessSettings& S) { S.ColorContrastShadows.X = 1.1; },
		[](FPostProcessSettings& S) { S.ColorGammaMidtones.Y = 1.1; },
		[](FPostProcessSettings& S) { S.ColorGainHighlights.Z = 1.1; },
		[](FPostProcessSettings& S)
		{
			S.ColorOffsetHighlights.W = 0.01;
		}};
	for (const auto& Change : Changes)
	{
		FPostProcessSettings Settings;
		Change(Settings);
		EXPECT_FALSE(MakeColorGrading(Settings).bNeutral);
	}
}

TEST(ColorGrading, GlobalAndRangeMultiplyOffsetsAdd)
{
	FPostProcessSettings Settings;
	Settings.ColorGain = FVector4(2, 1, 1, 0.5);
	Settings.ColorGainShadows = FVector4(3, 1, 1, 4);
	Settings.ColorOffset = FVector4(0.25, 0, 0, 0.5);
	Settings.ColorOffsetHighlights = FVector4(0.125, 0, 0, 1);
	const FColorGrading Grading = MakeColorGrading(Settings);
	EXPECT_EQ(2.0f * 3.0f * 0.5f * 4.0f, Grading.Gain[0].X);
	EXPECT_EQ(2.0f * 0.5f, Grading.Gain[1].X);
	EXPECT_EQ(0.25f + 0.125f + 0.5f + 1.0f, Grading.Offset[2].X);
	EXPECT_EQ(0.5f, Grading.Offset[0].Y);
}
