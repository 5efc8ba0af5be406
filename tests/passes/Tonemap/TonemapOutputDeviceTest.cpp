// Encodings of the output devices, the gamma-only path, and the ACES tone scales at their published points.
#include "TonemapTestUtils.h"

#include "ToneReference.h"

using namespace TonemapTest;
using PassReference::MaxDifference;
using PassTest::FScopedConsoleVariable;
using PassTest::Infinity;
using PassTest::NaN;

namespace
{

constexpr const TCHAR* Device = TEXT("r.HDR.Display.OutputDevice");

double DecodePQ(double Code)
{
	const double N = std::pow(Code, 1 / 78.84375);
	return 10000 * std::pow(std::max(N - 0.8359375, 0.0) / (18.8515625 - 18.6875 * N), 1 / 0.1593017578125);
}

/** Grey in, code value out. */
double GreyTo(double Grey, float OutputDevice, bool bLUT = false)
{
	const FScopedConsoleVariable Variable(Device, OutputDevice);
	return TonemapPixel({Grey, Grey, Grey, 1}, {.bLUT = bLUT})[1];
}

} // namespace

TEST(OutputDevice, Rec709CurveInPlaceOfSrgb)
{
	EXPECT_NEAR(1.099 * std::pow(0.18, 0.45) - 0.099, GreyTo(0.18, 1), 1e-5);
}

TEST(OutputDevice, ExplicitGammaIsAPower)
{
	const FScopedConsoleVariable Gamma(TEXT("r.TonemapperGamma"), 2.2f);
	EXPECT_NEAR(std::pow(0.18, 1 / 2.2), GreyTo(0.18, 2), 1e-5);
}

TEST(OutputDevice, TonemapperGammaReplacesTheCurveOfADisplay)
{
	const FScopedConsoleVariable Gamma(TEXT("r.TonemapperGamma"), 2.4f);
	EXPECT_EQ(EDisplayOutputFormat::SDR_ExplicitGammaMapping, GetTonemapperOutputDeviceParameters().OutputDevice);
	EXPECT_NEAR(std::pow(0.18, 1 / 2.4), GreyTo(0.18, 0), 1e-5);
}

TEST(OutputDevice, TonemapperGammaBelowOneIsOne)
{
	const FScopedConsoleVariable Gamma(TEXT("r.TonemapperGamma"), 0.5f);
	EXPECT_NEAR(0.18, GreyTo(0.18, 0), 1e-5);
}

TEST(OutputDevice, AcesPutsMiddleGreyAtTenNits)
{
	// The published middle points: 0.18 to 4.8 of the reference, to 10 nits of both displays.
	const FScopedConsoleVariable Multiplier(TEXT("r.HDR.Aces.SceneColorMultiplier"), 1.0f);
	for (const float OutputDevice : {3.0f, 4.0f})
	{
		EXPECT_NEAR(10, DecodePQ(GreyTo(0.18, OutputDevice)), 0.01) << OutputDevice;
	}
}

TEST(OutputDevice, AcesReachesTheDisplaysWhite)
{
	// The published last points: 0.18 * 2^10 to 1000 nits, 0.18 * 2^11 to 2000; scRGB counts 80 nits as 1.
	const FScopedConsoleVariable Multiplier(TEXT("r.HDR.Aces.SceneColorMultiplier"), 1.0f);
	EXPECT_NEAR(1000, DecodePQ(GreyTo(0.18 * 1024, 3)), 1);
	EXPECT_NEAR(2000, DecodePQ(GreyTo(0.18 * 2048, 4)), 2);
	EXPECT_NEAR(1000.0 / 80, GreyTo(0.18 * 1024, 5), 0.01);
	EXPECT_NEAR(2000.0 / 80, GreyTo(0.18 * 2048, 6), 0.02);
}

TEST(OutputDevice, AcesRisesMonotonicallyAndJoinsItsPieces)
{
	const FImage Ramp = FImage::Make(1024, 1,
		[](int X, int)
		{
			const double Grey = std::exp2((X - 700) / 32.0);
			return FTexel{Grey, Grey, Grey, 1};
		});
	for (const float OutputDevice : {3.0f, 4.0f})
	{
		const FScopedConsoleVariable Variable(Device, OutputDevice);
		const FImage Result = Tonemap(Ramp);
		for (int X = 1; X < 1024; ++X)
		{
			const double Rise = Result.At(X, 0)[1] - Result.At(X - 1, 0)[1];
			EXPECT_TRUE(Rise > -1e-5 && Rise < 0.01) << X << " " << Rise;
		}
	}
}

TEST(OutputDevice, BlackIsZeroNits)
{
	EXPECT_NEAR(0, DecodePQ(GreyTo(0, 3)), 1e-4);
	EXPECT_NEAR(0, GreyTo(0, 5), 1e-6);
}

TEST(OutputDevice, WithoutToneCurveLightIsAsItWas)
{
	// Greys pass gamut expansion and the matrices unchanged.
	for (const float OutputDevice : {7.0f, 8.0f})
	{
		EXPECT_NEAR(0.18, GreyTo(0.18, OutputDevice), 1e-6);
		EXPECT_NEAR(12, GreyTo(12, OutputDevice), 1e-5);
	}
}

TEST(OutputDevice, WithToneCurveIsTheFilmCurveInLinearLight)
{
	EXPECT_NEAR(0.723359, GreyTo(1, 9), 2e-6);
}

TEST(OutputDevice, TheTableFollows)
{
	// 32 positions between 0 and 10000 nits, in half float: a hundredth of the value.
	for (const float OutputDevice : {3.0f, 5.0f, 8.0f, 9.0f})
	{
		for (const double Grey : {0.18, 1.0, 20.0})
		{
			const double Exact = GreyTo(Grey, OutputDevice);
			EXPECT_NEAR(Exact, GreyTo(Grey, OutputDevice, true), 0.03 * Exact) << OutputDevice << " " << Grey;
		}
	}
}

TEST(OutputDevice, HazardsAreFinite)
{
	for (int OutputDevice = 0; OutputDevice < static_cast<int>(EDisplayOutputFormat::MAX); ++OutputDevice)
	{
		const FScopedConsoleVariable Variable(Device, static_cast<float>(OutputDevice));
		for (const FTexel& Color : {FTexel{NaN, -1, Infinity, 1}, {Infinity, Infinity, Infinity, 1}, {65504, 0, 0, 1}})
		{
			for (const bool bLUT : {false, true})
			{
				const FTexel Result = TonemapPixel(Color, {.bLUT = bLUT});
				EXPECT_TRUE(std::isfinite(Result[0] + Result[1] + Result[2])) << OutputDevice << " table " << bLUT;
			}
		}
	}
}

TEST(OutputDevice, FormatsCarryTheirRange)
{
	EXPECT_EQ(PF_B8G8R8A8, Drydock::GetDisplayFormat(EDisplayOutputFormat::SDR_sRGB));
	EXPECT_EQ(PF_A2B10G10R10, Drydock::GetDisplayFormat(EDisplayOutputFormat::HDR_ACES_1000nit_ST2084));
	EXPECT_EQ(PF_FloatRGBA, Drydock::GetDisplayFormat(EDisplayOutputFormat::HDR_LinearNoToneCurve));
	EXPECT_EQ(PF_A32B32G32R32F, Drydock::GetDisplayFormat(EDisplayOutputFormat::HDR_LinearEXR));
}

TEST(GammaOnly, IsThePowerOfTheDisplayAndNothingElse)
{
	const FTexel Result = TonemapPixel({0.25, 4, 0.5, 1}, {.Settings =
																  [](FFinalPostProcessSettings& Settings)
															  {
																  Settings.VignetteIntensity = 1;
																  Settings.SceneColorTint = FLinearColor(0, 0, 0);
																  Settings.FilmGrainIntensity = 1;
															  },
															  .bGammaOnly = true});
	EXPECT_NEAR(std::pow(0.25, 1 / 2.2), Result[0], 1e-6);
	EXPECT_NEAR(std::pow(4, 1 / 2.2), Result[1], 1e-6);
}

TEST(GammaOnly, NaNAndNegativeCountAsZero)
{
	const FTexel Result = TonemapPixel({NaN, -1, 0, 1}, {.bGammaOnly = true});
	EXPECT_EQ((FTexel{0, 0, 0, 0}), Result);
}
