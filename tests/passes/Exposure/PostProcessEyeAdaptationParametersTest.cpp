// What settings and console variables say about metering and adaptation, against the formulas, without a pass.
#include <gtest/gtest.h>

#include "Exposure/PostProcessEyeAdaptationParameters.h"

#include "HAL/ConsoleVariableTools.h"
#include "SceneRendering.h"

#include <cmath>
#include <limits>
#include <random>

using namespace Drydock;

namespace
{

FEyeAdaptationParameters GetParameters(
	const FFinalPostProcessSettings& Settings, EAutoExposureMethod Method = AEM_Histogram)
{
	FViewInfo View(nullptr, FIntRect(0, 0, 1, 1), FIntPoint(1, 1));
	View.FinalPostProcessSettings = Settings;
	return GetEyeAdaptationParameters(View, Method, false);
}

} // namespace

TEST(EyeAdaptationMethod, VariablesHaveTheLastWord)
{
	FFinalPostProcessSettings Settings;
	EXPECT_EQ(AEM_Histogram, GetAutoExposureMethod(Settings));
	{
		const FScopedConsoleVariable Low(TEXT("r.EyeAdaptationQuality"), 1.0f);
		EXPECT_EQ(AEM_Basic, GetAutoExposureMethod(Settings));
		Settings.AutoExposureMethod = AEM_Manual;
		EXPECT_EQ(AEM_Manual, GetAutoExposureMethod(Settings));
	}
	const FScopedConsoleVariable Override(TEXT("r.EyeAdaptation.MethodOverride"), 2.0f);
	EXPECT_EQ(AEM_Basic, GetAutoExposureMethod(Settings));
}

TEST(EyeAdaptationParameters, TheHistogramHoldsItsRange)
{
	std::mt19937 Random(1);
	std::uniform_real_distribution<float> Log(-20.0f, 20.0f);
	for (int Case = 0; Case < 100; ++Case)
	{
		FFinalPostProcessSettings Settings;
		Settings.HistogramLogMin = Log(Random);
		Settings.HistogramLogMax = Settings.HistogramLogMin + 1.0f + std::abs(Log(Random));
		const FEyeAdaptationParameters Parameters = GetParameters(Settings);
		EXPECT_NEAR(0.0, Settings.HistogramLogMin * Parameters.HistogramScale + Parameters.HistogramBias, 1e-5);
		EXPECT_NEAR(1.0, Settings.HistogramLogMax * Parameters.HistogramScale + Parameters.HistogramBias, 1e-5);
		EXPECT_FLOAT_EQ(std::exp2(Settings.HistogramLogMin), Parameters.LuminanceMin);
	}
}

TEST(EyeAdaptationParameters, NoSettingGivesAnEmptyRange)
{
	constexpr float Infinity = std::numeric_limits<float>::infinity();
	for (const float Min : {-Infinity, -1e30f, -4.0f, 0.0f, 1e9f, Infinity})
	{
		for (const float Max : {-Infinity, -1e30f, -4.0f, 0.0f, 1e9f, Infinity})
		{
			FFinalPostProcessSettings Settings;
			Settings.HistogramLogMin = Min;
			Settings.HistogramLogMax = Max;
			const FVector2f Range = GetHistogramLogRange(Settings, AEM_Histogram);
			EXPECT_LE(-60.0f, Range.X) << Min << " " << Max;
			EXPECT_LE(Range.X + 1.0f, Range.Y) << Min << " " << Max;
			EXPECT_GE(60.0f, Range.Y) << Min << " " << Max;
		}
	}
	EXPECT_EQ(FVector2f(-10.0f, 20.0f), GetHistogramLogRange({}, AEM_Basic));
}

TEST(EyeAdaptationParameters, TheCamerasEV100IsThatOfPhotography)
{
	FFinalPostProcessSettings Settings;
	// "Sunny 16": f/16, 1/125 s at ISO 100 is EV 15 (log2(256 * 125) = 14.97).
	Settings.DepthOfFieldFstop = 16.0f;
	Settings.CameraShutterSpeed = 125.0f;
	Settings.CameraISO = 100.0f;
	EXPECT_NEAR(14.966, GetManualExposureEV100(Settings), 1e-3);
	const float Bright = GetManualExposureEV100(Settings);
	Settings.CameraISO = 400.0f;
	EXPECT_NEAR(Bright - 2.0f, GetManualExposureEV100(Settings), 1e-5);
	Settings.AutoExposureApplyPhysicalCameraExposure = false;
	EXPECT_EQ(0.0f, GetManualExposureEV100(Settings));
}

TEST(EyeAdaptationParameters, ALuminanceAndItsEV100)
{
	EXPECT_FLOAT_EQ(1.0f, GetEyeAdaptationLuminanceMax()); // 0.78 / 0.78
	EXPECT_FLOAT_EQ(3.0f, LuminanceToEV100(8.0f));
	const FScopedConsoleVariable Attenuation(TEXT("r.EyeAdaptation.LensAttenuation"), 0.39f);
	EXPECT_FLOAT_EQ(2.0f, GetEyeAdaptationLuminanceMax());
	EXPECT_FLOAT_EQ(2.0f, LuminanceToEV100(8.0f));
}

TEST(EyeAdaptationParameters, AtTheStartDistanceBothSpeedsAreOne)
{
	std::mt19937 Random(2);
	std::uniform_real_distribution<float> Speeds(0.1f, 20.0f), Distances(0.1f, 4.0f);
	for (int Case = 0; Case < 100; ++Case)
	{
		const float Distance = Distances(Random);
		const FScopedConsoleVariable Transition(TEXT("r.EyeAdaptation.ExponentialTransitionDistance"), Distance);
		FFinalPostProcessSettings Settings;
		Settings.AutoExposureSpeedUp = Speeds(Random);
		const FEyeAdaptationParameters Parameters = GetParameters(Settings);
		// Of a frame of 1/60 s: linear goes speed / 60, exponential (1 - 2^(-speed / 60)) * M of the distance's speed.
		const double Frame = 1.0 / 60, Speed = Settings.AutoExposureSpeedUp;
		const double Exponential = (1 - std::exp2(-Frame * Speed)) * Parameters.ExponentialUpM * Distance / Speed;
		EXPECT_NEAR(Frame, Exponential, 1e-4 * Frame) << Speed << " " << Distance;
	}
}

TEST(EyeAdaptationParameters, PercentagesAreInOrder)
{
	FFinalPostProcessSettings Settings;
	Settings.AutoExposureLowPercent = 80.0f;
	Settings.AutoExposureHighPercent = 20.0f;
	const FEyeAdaptationParameters Parameters = GetParameters(Settings);
	EXPECT_FLOAT_EQ(0.8f, Parameters.ExposureLowPercent);
	EXPECT_FLOAT_EQ(0.8f, Parameters.ExposureHighPercent);
}

TEST(EyeAdaptationParameters, WhereThereIsNoRangeTheTargetIsForced)
{
	FFinalPostProcessSettings Settings;
	EXPECT_EQ(0.0f, GetParameters(Settings).ForceTarget);
	EXPECT_EQ(1.0f, GetParameters(Settings, AEM_Manual).ForceTarget);
	Settings.AutoExposureMinBrightness = Settings.AutoExposureMaxBrightness = 2.0f;
	EXPECT_EQ(1.0f, GetParameters(Settings).ForceTarget);
	EXPECT_FLOAT_EQ(2.0f * 0.18f, GetParameters(Settings).MinAverageLuminance);
	EXPECT_FLOAT_EQ(2.0f * 0.18f, GetParameters(Settings).MaxAverageLuminance);
}
