// The eye-adaptation buffer, read back as a shader would see it: of a given exposure, of the camera, metered by
// histogram and average; its way over time against the engine's formulas.
#include <gtest/gtest.h>

#include "ExposureTestUtils.h"

#include "Exposure/PostProcessEyeAdaptation.h"

#include "Misc/AssertionMacros.h"
#include "RHICommandList.h"
#include "RHIGPUReadback.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace Drydock;

namespace
{

std::vector<FVector4f> ReadEyeAdaptation(float ExposureScale)
{
	FRHIGPUBufferReadback Readback(TEXT("EyeAdaptation"));
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGBufferRef Buffer = CreateEyeAdaptationBuffer(GraphBuilder, ExposureScale);
	AddEnqueueCopyPass(GraphBuilder, &Readback, Buffer, Buffer->Desc.GetSize());
	GraphBuilder.Execute();

	const uint32 NumBytes = GEyeAdaptationBufferEntries * sizeof(FVector4f);
	const FVector4f* Entries = static_cast<const FVector4f*>(Readback.Lock(NumBytes));
	const std::vector<FVector4f> Result(Entries, Entries + GEyeAdaptationBufferEntries);
	Readback.Unlock();
	return Result;
}

} // namespace

TEST(PostProcessEyeAdaptationTest, FirstEntryHoldsTheScaleAsReachedAndAsTarget)
{
	const FVector4f Entry = ReadEyeAdaptation(4.0f)[0];
	EXPECT_EQ(4.0f, Entry.X);
	EXPECT_EQ(4.0f, Entry.Y);
}

TEST(PostProcessEyeAdaptationTest, AverageLuminanceIsWhatTheScaleBringsToMiddleGrey)
{
	EXPECT_FLOAT_EQ(0.045f, ReadEyeAdaptation(4.0f)[0].Z); // 0.18 / 4
	EXPECT_FLOAT_EQ(0.36f, ReadEyeAdaptation(0.5f)[0].Z);  // 0.18 / 0.5
}

TEST(PostProcessEyeAdaptationTest, CompensationAndLocalExposureAreNeutral)
{
	const std::vector<FVector4f> Entries = ReadEyeAdaptation(4.0f);
	EXPECT_EQ(1.0f, Entries[0].W);
	EXPECT_EQ(1.0f, Entries[1].X);
}

TEST(PostProcessEyeAdaptationTest, ExtremeScalesStayFinite)
{
	for (const float Scale : {1.0e-30f, 1.0e30f})
	{
		const FVector4f Entry = ReadEyeAdaptation(Scale)[0];
		EXPECT_EQ(Scale, Entry.X);
		EXPECT_TRUE(std::isfinite(Entry.Z)) << Scale;
	}
}

TEST(PostProcessEyeAdaptationTest, ScaleMustBePositiveAndFinite)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	for (const float Scale :
		{0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
	{
		EXPECT_THROW(CreateEyeAdaptationBuffer(GraphBuilder, Scale), Drydock::FCheckFailure) << Scale;
	}
	GraphBuilder.Execute();
}

using namespace PassTest;

namespace
{

/** Exposure value of luminance 1/4: what the frames below settle on. Compensation 2 is the default bias of 1. */
constexpr double Target = 0.25 / 0.18;

FMetering WithSettings(
	std::function<void(FFinalPostProcessSettings&)> Settings, EAutoExposureMethod Method = AEM_Histogram)
{
	FMetering Metering;
	Metering.Method = Method;
	Metering.Settings = std::move(Settings);
	return Metering;
}

/** A frame of luminance 1/4 after one whose exposure value was Distance EV above the target. Result: the distance now.
 */
double AdaptFrom(double Distance, FMetering Metering)
{
	Metering.LastScale = static_cast<float>(2 / (Target * std::exp2(Distance)));
	return std::log2(2 / static_cast<double>(Meter(Grey(0.25), Metering).X) / Target);
}

double AdaptFrom(double Distance, float DeltaTime)
{
	// The greatest brightness, 8, would hold back what comes from 4 EV above.
	FMetering Metering = WithSettings([](auto& Settings) { Settings.AutoExposureMaxBrightness = 64; });
	Metering.DeltaTime = DeltaTime;
	return AdaptFrom(Distance, Metering);
}

} // namespace

TEST(HistogramEyeAdaptation, AFlatFrameIsBroughtToTwiceMiddleGrey)
{
	const FVector4f Entry = Meter(Grey(0.25));
	EXPECT_NEAR(1.44f, Entry.X, 1e-5f); // 2^bias * 0.18 / 0.25
	EXPECT_NEAR(1.44f, Entry.Y, 1e-5f);
	EXPECT_NEAR(0.25f, Entry.Z, 1e-6f);
	EXPECT_EQ(2.0f, Entry.W);
}

TEST(HistogramEyeAdaptation, DarkAndBrightOutliersAreLeftOut)
{
	// Buckets 1..63 hold 1/64 each, black nothing. Between 10 and 90 % lie 0.7 of bucket 7, 8..56 and 0.7 of bucket 57:
	// their middle is bucket 32.
	EXPECT_NEAR(BucketLuminance(32), Meter(BucketRamp()).Z, 1e-5);
	// Between 50 and 90 %: half of bucket 32, 33..56 and 0.7 of bucket 57.
	const FMetering Upper =
		WithSettings([](FFinalPostProcessSettings& Settings) { Settings.AutoExposureLowPercent = 50; });
	const double Middle = (0.5 * 32 + 24 * 44.5 + 0.7 * 57) / (0.5 + 24 + 0.7);
	EXPECT_NEAR(BucketLuminance(Middle), Meter(BucketRamp(), Upper).Z, 1e-4);
}

TEST(HistogramEyeAdaptation, PercentagesStayWithinOneAndNinetyNine)
{
	FViewInfo View(nullptr, FIntRect(0, 0, 1, 1), FIntPoint(1, 1));
	View.FinalPostProcessSettings.AutoExposureLowPercent = -5;
	View.FinalPostProcessSettings.AutoExposureHighPercent = 200;
	const FEyeAdaptationParameters Parameters = GetEyeAdaptationParameters(View, AEM_Histogram, true);
	EXPECT_FLOAT_EQ(0.01f, Parameters.ExposureLowPercent);
	EXPECT_FLOAT_EQ(0.99f, Parameters.ExposureHighPercent);
}

TEST(HistogramEyeAdaptation, BrightnessLimitsHoldTheExposureNotTheAverage)
{
	const FMetering Limits = WithSettings(
		[](FFinalPostProcessSettings& Settings)
		{
			Settings.AutoExposureMinBrightness = 0.5;
			Settings.AutoExposureMaxBrightness = 4;
		});
	EXPECT_NEAR(4.0f, Meter(Grey(0.0625), Limits).X, 1e-5f); // 2 / 0.5
	EXPECT_NEAR(0.0625f, Meter(Grey(0.0625), Limits).Z, 1e-6f);
	EXPECT_NEAR(0.5f, Meter(Grey(4), Limits).X, 1e-5f); // 2 / 4
}

TEST(HistogramEyeAdaptation, BiasIsInStops)
{
	EXPECT_NEAR(5.76f, Meter(Grey(0.25), WithSettings([](auto& Settings) { Settings.AutoExposureBias = 3; })).X, 1e-4f);
}

TEST(HistogramEyeAdaptation, BlackNaNAndInfiniteFramesHaveAnExposure)
{
	// An empty histogram averages to log2 luminance 0.
	EXPECT_NEAR(0.36f, Meter(Grey(0)).X, 1e-6f);
	EXPECT_NEAR(0.36f, Meter(Grey(NaN)).X, 1e-6f);
	// The brightest bucket is 16; the greatest brightness, 8, is the limit.
	EXPECT_NEAR(16.0f, Meter(Grey(Infinity)).Z, 1e-4f);
	EXPECT_NEAR(0.25f, Meter(Grey(Infinity)).X, 1e-6f);
}

TEST(HistogramEyeAdaptation, ExtendedRangeIsInEV100)
{
	const FScopedConsoleVariable Extended(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"), 1.0f);
	const FMetering Range = WithSettings(
		[](FFinalPostProcessSettings& Settings)
		{
			Settings.AutoExposureMinBrightness = Settings.HistogramLogMin = -10;
			Settings.AutoExposureMaxBrightness = Settings.HistogramLogMax = 20;
		});
	// log2 -2 lies at 8/30 * 63 = 16.8: 0.2 in bucket 16, 0.8 in 17; without the outer tenths 0.1 and 0.7.
	const double Bucket = (16 * 0.1 + 17 * 0.7) / 0.8;
	EXPECT_NEAR(std::exp2(-10 + 30 * Bucket / 63), Meter(Grey(0.25), Range).Z, 1e-5);
	EXPECT_NEAR(2.0f / 1024,
		Meter(Grey(1e9), WithSettings(
							 [](FFinalPostProcessSettings& Settings)
							 {
								 Settings.HistogramLogMin = -10;
								 Settings.HistogramLogMax = 20;
								 Settings.AutoExposureMinBrightness = 0;
								 Settings.AutoExposureMaxBrightness = 10;
							 }))
			.X,
		1e-7f);
}

TEST(BasicEyeAdaptation, ExposesForTheGeometricMean)
{
	const FImage Halves = FImage::Make(2, 1,
		[](int X, int) {
			return X == 0 ? FTexel{0.25, 0.25, 0.25, 1} : FTexel{1, 1, 1, 1};
		});
	EXPECT_NEAR(0.5f, Meter(Halves, WithSettings({}, AEM_Basic)).Z, 1e-4f);
	EXPECT_NEAR(0.72f, Meter(Halves, WithSettings({}, AEM_Basic)).X, 1e-5f);
}

TEST(BasicEyeAdaptation, AHalfFloatStoreIsWithinAFewThousandths)
{
	FMetering Metering = WithSettings({}, AEM_Basic);
	Metering.Arithmetic = EArithmetic::Native;
	// 8/30 as a half: at most 2^-13 off, times 30 EV.
	EXPECT_NEAR(0.25f, Meter(Grey(0.25), Metering).Z, 0.25f * 0.0026f);
}

TEST(BasicEyeAdaptation, TheMaskWeighsAtLeastATwentieth)
{
	const FImage Halves = FImage::Make(2, 1,
		[](int X, int) {
			return X == 0 ? FTexel{1, 1, 1, 1} : FTexel{4, 4, 4, 1};
		});
	FMetering Metering = WithSettings({}, AEM_Basic);
	Metering.Mask = FImage::Make(2, 1, [](int X, int) { return FTexel{X == 0 ? 1.0 : 0.0, 0, 0, 0}; });
	EXPECT_NEAR(std::exp2(2 * 0.05 / 1.05), Meter(Halves, Metering).Z, 1e-4);
}

TEST(BasicEyeAdaptation, BlackAndNaNAreTheLowestLuminance)
{
	EXPECT_NEAR(std::exp2(-10.0), Meter(Grey(0), WithSettings({}, AEM_Basic)).Z, 1e-6);
	EXPECT_NEAR(std::exp2(-10.0), Meter(Grey(NaN), WithSettings({}, AEM_Basic)).Z, 1e-6);
	EXPECT_NEAR(65536.0f, Meter(Grey(Infinity), WithSettings({}, AEM_Basic)).Z, 4.0f);
}

TEST(ManualEyeAdaptation, TheCameraExposes)
{
	// f/4, 1/60 s, ISO 100: 16 * 60.
	EXPECT_NEAR(2.0f / 960, Meter(Grey(1), WithSettings({}, AEM_Manual)).X, 1e-8f);
	EXPECT_NEAR(2.0f / 480,
		Meter(Grey(1), WithSettings([](auto& Settings) { Settings.CameraISO = 200; }, AEM_Manual)).X, 1e-8f);
	const auto NoCamera = [](FFinalPostProcessSettings& Settings)
	{
		Settings.AutoExposureApplyPhysicalCameraExposure = false;
		Settings.AutoExposureBias = 2;
	};
	EXPECT_NEAR(4.0f, Meter(Grey(1), WithSettings(NoCamera, AEM_Manual)).X, 1e-6f);
}

TEST(ManualEyeAdaptation, LensAttenuationCountsWithTheExtendedRange)
{
	const FScopedConsoleVariable Attenuation(TEXT("r.EyeAdaptation.LensAttenuation"), 0.39f);
	EXPECT_NEAR(2.0f / 960, Meter(Grey(1), WithSettings({}, AEM_Manual)).X, 1e-8f);
	const FScopedConsoleVariable Extended(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"), 1.0f);
	EXPECT_NEAR(1.0f / 960, Meter(Grey(1), WithSettings({}, AEM_Manual)).X, 1e-8f);
}

TEST(EyeAdaptationOverTime, FarAwayItIsLinear)
{
	EXPECT_NEAR(-4 + 0.1 * 3, AdaptFrom(-4, 0.1f), 1e-4); // the scene got brighter: 3 EV per second
	EXPECT_NEAR(4 - 0.1 * 1, AdaptFrom(4, 0.1f), 1e-4);   // darker: 1
}

TEST(EyeAdaptationOverTime, NearByItSlowsDownExponentially)
{
	// M(3) = 0.97856, M(1) = 0.96736.
	EXPECT_NEAR(-1 + (1 - std::exp2(-0.3)) * 0.97856, AdaptFrom(-1, 0.1f), 1e-4);
	EXPECT_NEAR(1 - (1 - std::exp2(-0.1)) * 0.96736, AdaptFrom(1, 0.1f), 1e-4);
}

TEST(EyeAdaptationOverTime, SettlesInTheTimeOfTheFormulas)
{
	// From 4 EV below at 60 frames a second: 50 frames of 0.05 EV to 1.5 EV, then each frame leaves 1 - 0.05 / 1.5.
	double Distance = -4;
	for (int Frame = 0; Frame < 50; ++Frame)
	{
		Distance = AdaptFrom(Distance, 1.0f / 60.0f);
	}
	EXPECT_NEAR(-1.5, Distance, 1e-3);
	for (int Frame = 0; Frame < 60; ++Frame)
	{
		Distance = AdaptFrom(Distance, 1.0f / 60.0f);
	}
	EXPECT_NEAR(-1.5 * std::pow(1 - 0.05 / 1.5, 60), Distance, 1e-3);
}

TEST(EyeAdaptationOverTime, TheTransitionDistanceIsAVariable)
{
	const FScopedConsoleVariable Near(TEXT("r.EyeAdaptation.ExponentialTransitionDistance"), 0.5f);
	EXPECT_NEAR(-0.7, AdaptFrom(-1, 0.1f), 1e-4);
}

TEST(EyeAdaptationOverTime, ALongFrameEndsAtTheTarget)
{
	EXPECT_NEAR(0, AdaptFrom(-4, 100.0f), 1e-4);
	EXPECT_NEAR(0, AdaptFrom(4, 100.0f), 1e-4);
	const double Rest = AdaptFrom(-1, 100.0f);
	EXPECT_NEAR(-1 + 0.97856, Rest, 1e-4);
}

TEST(EyeAdaptationOverTime, WithoutTimeNothingMoves)
{
	EXPECT_NEAR(-4, AdaptFrom(-4, 0.0f), 1e-4);
	EXPECT_NEAR(0.5, AdaptFrom(0.5, 0.0f), 1e-4);
}

TEST(EyeAdaptationOverTime, TheTargetScaleIsThereAtOnce)
{
	FMetering Metering;
	Metering.LastScale = 10.0f;
	EXPECT_NEAR(1.44f, Meter(Grey(0.25), Metering).Y, 1e-5f);
}

TEST(EyeAdaptationOverTime, CutsNegativeSpeedsAndNoRangeDoNotAdapt)
{
	FMetering Cut;
	Cut.bCameraCut = true;
	EXPECT_NEAR(0, AdaptFrom(-4, Cut), 1e-4);
	EXPECT_NEAR(0, AdaptFrom(-4, WithSettings([](auto& Settings) { Settings.AutoExposureSpeedDown = -1; })), 1e-4);
	const auto NoRange = [](FFinalPostProcessSettings& Settings)
	{
		Settings.AutoExposureMinBrightness = Settings.AutoExposureMaxBrightness = 1;
	};
	FMetering Fixed = WithSettings(NoRange);
	Fixed.LastScale = 10.0f;
	EXPECT_NEAR(2.0f, Meter(Grey(0.25), Fixed).X, 1e-5f);
}

TEST(EyeAdaptationOverTime, BasicMeteringAdaptsAlike)
{
	EXPECT_NEAR(-3.7,
		AdaptFrom(-4,
			[]
			{
				FMetering Metering = WithSettings({}, AEM_Basic);
				Metering.DeltaTime = 0.1f;
				return Metering;
			}()),
		1e-4);
}
