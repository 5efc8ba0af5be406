// Overriding by weight, and the last word of console variables and show flags. Rules: the engine's, as published.
#include <gtest/gtest.h>

#include "FinalPostProcessSettings.h"
#include "HAL/ConsoleVariableTools.h"

#include <cmath>

using namespace Drydock;

namespace
{

FPostProcessSettings BloomOf(float Intensity)
{
	FPostProcessSettings Settings;
	Settings.bOverride_BloomIntensity = true;
	Settings.BloomIntensity = Intensity;
	return Settings;
}

std::string ReasonOf(const std::vector<FSettingGate>& Gates, const std::string& Setting)
{
	for (const FSettingGate& Gate : Gates)
	{
		if (Gate.Setting == Setting)
		{
			return Gate.Reason;
		}
	}
	return "";
}

} // namespace

TEST(OverrideSettings, FieldsWithoutOverrideBitDoNotMove)
{
	FFinalPostProcessSettings Settings;
	FPostProcessSettings Source;
	Source.BloomIntensity = 5.0f;
	OverridePostProcessSettings(Settings, Source, 1.0f);
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
}

TEST(OverrideSettings, TwoHalfWeightsKeepAQuarterOfTheBase)
{
	FFinalPostProcessSettings Settings;
	Settings.BloomIntensity = 4.0f;
	OverridePostProcessSettings(Settings, BloomOf(8.0f), 0.5f);
	OverridePostProcessSettings(Settings, BloomOf(16.0f), 0.5f);
	EXPECT_EQ(0.25f * 4.0f + 0.25f * 8.0f + 0.5f * 16.0f, Settings.BloomIntensity);
}

TEST(OverrideSettings, WeightAboveOneIsOne)
{
	FFinalPostProcessSettings Settings;
	OverridePostProcessSettings(Settings, BloomOf(2.0f), 3.0f);
	EXPECT_EQ(2.0f, Settings.BloomIntensity);
}

TEST(OverrideSettings, WeightNotAboveZeroDoesNothing)
{
	FFinalPostProcessSettings Settings;
	for (const float Weight : {0.0f, -1.0f, std::nanf("")})
	{
		OverridePostProcessSettings(Settings, BloomOf(2.0f), Weight);
	}
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(OverrideSettings, MarksWhatItBlended)
{
	FFinalPostProcessSettings Settings;
	OverridePostProcessSettings(Settings, BloomOf(2.0f), 0.5f);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomThreshold);
}

TEST(StartSettings, DefaultFeatureBloomOffMeansNoIntensity)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), FString("0.0"));
	EXPECT_EQ(0.0f, StartFinalPostProcessSettings().BloomIntensity);
}

TEST(StartSettings, DefaultFeatureBloomOffTakesTheToonStrengthAlong)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
	FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	EXPECT_EQ(0.0f, Settings.BloomToonIntensity);
	FPostProcessSettings Volume;
	Volume.bOverride_BloomToonIntensity = true;
	Volume.BloomToonIntensity = 1.0f;
	OverridePostProcessSettings(Settings, Volume, 0.5f);
	EXPECT_EQ(0.5f, Settings.BloomToonIntensity); // half way from 0, not from 0.675
}

TEST(StartSettings, DefaultBiasIsAVariable)
{
	EXPECT_EQ(1.0f, StartFinalPostProcessSettings().AutoExposureBias);
	const FScopedConsoleVariable Bias(TEXT("r.DefaultFeature.AutoExposure.Bias"), FString("2.5"));
	EXPECT_EQ(2.5f, StartFinalPostProcessSettings().AutoExposureBias);
}

TEST(EndSettings, DefaultsStayAsTheyAre)
{
	FFinalPostProcessSettings Settings;
	EXPECT_TRUE(EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game)).empty());
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_EQ(0.675f, Settings.BloomToonIntensity);
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
}

TEST(EndSettings, ShowFlagBloomSwitchesBloomOff)
{
	FFinalPostProcessSettings Settings;
	FEngineShowFlags Flags(ESFIM_Game);
	Flags.SetBloom(false);
	EXPECT_EQ("ShowFlag.Bloom is off", ReasonOf(EndFinalPostProcessSettings(Settings, Flags), "BloomIntensity"));
	EXPECT_EQ(0.0f, Settings.BloomIntensity);
}

TEST(EndSettings, WhatSwitchesBloomOffTakesTheToonStrengthAlong)
{
	FFinalPostProcessSettings ByVariable;
	{
		const FScopedConsoleVariable Quality(TEXT("r.BloomQuality"), 0);
		EXPECT_EQ("r.BloomQuality is 0",
			ReasonOf(EndFinalPostProcessSettings(ByVariable, FEngineShowFlags()), "BloomToonIntensity"));
	}
	EXPECT_EQ(0.0f, ByVariable.BloomToonIntensity);
	FFinalPostProcessSettings ByFlag;
	FEngineShowFlags Flags;
	Flags.SetBloom(false);
	EXPECT_EQ("ShowFlag.Bloom is off", ReasonOf(EndFinalPostProcessSettings(ByFlag, Flags), "BloomToonIntensity"));
	EXPECT_EQ(0.0f, ByFlag.BloomToonIntensity);
}

TEST(EndSettings, ZeroThatWasZeroIsNotListed)
{
	FFinalPostProcessSettings Settings;
	Settings.BloomIntensity = 0.0f;
	FEngineShowFlags Flags(ESFIM_Game);
	Flags.SetBloom(false);
	EXPECT_EQ("", ReasonOf(EndFinalPostProcessSettings(Settings, Flags), "BloomIntensity"));
}

TEST(EndSettings, LowTonemapperQualityHasNoVignette)
{
	FFinalPostProcessSettings Settings;
	const FScopedConsoleVariable Quality(TEXT("r.Tonemapper.Quality"), FString("1.0"));
	EXPECT_EQ("r.Tonemapper.Quality is below 2",
		ReasonOf(EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game)), "VignetteIntensity"));
	EXPECT_EQ(0.0f, Settings.VignetteIntensity);
}

TEST(EndSettings, TonemapperQualityTwoKeepsVignette)
{
	FFinalPostProcessSettings Settings;
	const FScopedConsoleVariable Quality(TEXT("r.Tonemapper.Quality"), FString("2.0"));
	EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game));
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
}

TEST(EndSettings, FlagsSwitchOffVignetteToneCurveAndFringe)
{
	FFinalPostProcessSettings Settings;
	Settings.SceneFringeIntensity = 1.0f;
	Settings.BloomDirtMaskIntensity = 1.0f;
	FEngineShowFlags Flags(ESFIM_Game);
	Flags.SetVignette(false);
	Flags.SetToneCurve(false);
	Flags.SetCameraImperfections(false);
	EXPECT_EQ(4u, EndFinalPostProcessSettings(Settings, Flags).size());
	EXPECT_EQ(0.0f, Settings.VignetteIntensity + Settings.ToneCurveAmount + Settings.SceneFringeIntensity +
						Settings.BloomDirtMaskIntensity);
}

TEST(EndSettings, FringeMaxLimits)
{
	FFinalPostProcessSettings Settings;
	Settings.SceneFringeIntensity = 4.0f;
	const FScopedConsoleVariable Max(TEXT("r.SceneColorFringe.Max"), FString("1.5"));
	EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game));
	EXPECT_EQ(1.5f, Settings.SceneFringeIntensity);
}

TEST(EndSettings, FringeTestValueForcesFive)
{
	FFinalPostProcessSettings Settings;
	const FScopedConsoleVariable Max(TEXT("r.SceneColorFringe.Max"), FString("-2.0"));
	EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game));
	EXPECT_EQ(5.0f, Settings.SceneFringeIntensity);
}

TEST(EndSettings, ExposureOffsetAddsToTheBias)
{
	FFinalPostProcessSettings Settings;
	const FScopedConsoleVariable Offset(TEXT("r.ExposureOffset"), FString("-0.5"));
	EndFinalPostProcessSettings(Settings, FEngineShowFlags(ESFIM_Game));
	EXPECT_EQ(0.5f, Settings.AutoExposureBias);
}

TEST(StartSettings, DefaultFeaturesSwitchTheirEffectsOff)
{
	const FScopedConsoleVariable Occlusion(TEXT("r.DefaultFeature.AmbientOcclusion"), 0);
	const FScopedConsoleVariable Fraction(TEXT("r.DefaultFeature.AmbientOcclusionStaticFraction"), 0);
	const FScopedConsoleVariable Blur(TEXT("r.DefaultFeature.MotionBlur"), 0);
	const FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	EXPECT_EQ(0.0f, Settings.AmbientOcclusionIntensity);
	EXPECT_EQ(0.0f, Settings.AmbientOcclusionStaticFraction);
	EXPECT_EQ(0.0f, Settings.MotionBlurAmount);
}

TEST(StartSettings, DefaultFeaturesLeaveThemOn)
{
	const FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_EQ(0.5f, Settings.AmbientOcclusionIntensity);
	EXPECT_EQ(1.0f, Settings.AmbientOcclusionStaticFraction);
	EXPECT_EQ(0.5f, Settings.MotionBlurAmount);
}

TEST(StartSettings, LensFlaresAreOffUnlessTheirFeatureIsOn)
{
	EXPECT_EQ(0.0f, StartFinalPostProcessSettings().LensFlareIntensity);
	const FScopedConsoleVariable On(TEXT("r.DefaultFeature.LensFlare"), 1);
	EXPECT_EQ(1.0f, StartFinalPostProcessSettings().LensFlareIntensity);
}

TEST(StartSettings, WithoutAutoExposureTheEyeStaysAtOne)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.AutoExposure"), 0);
	EXPECT_EQ(1.0f, StartFinalPostProcessSettings().AutoExposureMinBrightness);
	EXPECT_EQ(1.0f, StartFinalPostProcessSettings().AutoExposureMaxBrightness);
}

TEST(StartSettings, WithoutAutoExposureTheEyeStaysAtEVZeroInTheExtendedRange)
{
	// Luminance 1 is EV100 log2(1 / LuminanceMax), and LuminanceMax is 0.78 / 0.78.
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.AutoExposure"), 0);
	const FScopedConsoleVariable Extended(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"), 1);
	EXPECT_EQ(0.0f, StartFinalPostProcessSettings().AutoExposureMinBrightness);
	EXPECT_EQ(0.0f, StartFinalPostProcessSettings().AutoExposureMaxBrightness);
}

TEST(StartSettings, ExtendedRangeIsInEV100)
{
	const FScopedConsoleVariable Extended(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"), 1);
	const FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	EXPECT_EQ(-10.0f, Settings.AutoExposureMinBrightness);
	EXPECT_EQ(20.0f, Settings.AutoExposureMaxBrightness);
	EXPECT_EQ(-10.0f, Settings.HistogramLogMin);
	EXPECT_EQ(20.0f, Settings.HistogramLogMax);
}

TEST(StartSettings, DefaultMethodIsAVariable)
{
	const FScopedConsoleVariable Manual(TEXT("r.DefaultFeature.AutoExposure.Method"), 2);
	EXPECT_EQ(AEM_Manual, StartFinalPostProcessSettings().AutoExposureMethod);
}

TEST(StartSettings, UnknownMethodIsIgnored)
{
	const FScopedConsoleVariable Nonsense(TEXT("r.DefaultFeature.AutoExposure.Method"), 17);
	EXPECT_EQ(AEM_Histogram, StartFinalPostProcessSettings().AutoExposureMethod);
}

TEST(StartSettings, ContrastsHaveTheirOwnVariables)
{
	const FScopedConsoleVariable Highlights(
		TEXT("r.DefaultFeature.LocalExposure.HighlightContrastScale"), FString("0.75"));
	const FScopedConsoleVariable Shadows(TEXT("r.DefaultFeature.LocalExposure.ShadowContrastScale"), FString("0.5"));
	EXPECT_EQ(0.75f, StartFinalPostProcessSettings().LocalExposureHighlightContrastScale);
	EXPECT_EQ(0.5f, StartFinalPostProcessSettings().LocalExposureShadowContrastScale);
}

TEST(StartSettings, ShadowsTakeTheContrastThatTheEngineVersionSays)
{
	const FScopedConsoleVariable Highlights(
		TEXT("r.DefaultFeature.LocalExposure.HighlightContrastScale"), FString("0.75"));
	const FScopedConsoleVariable Shadows(TEXT("r.DefaultFeature.LocalExposure.ShadowContrastScale"), FString("0.5"));
	for (const FEngineProfile& Engine : GetEngineProfiles())
	{
		EXPECT_EQ(Engine.bShadowContrastOfHighlights ? 0.75f : 0.5f,
			StartFinalPostProcessSettings(nullptr, Engine).LocalExposureShadowContrastScale)
			<< Engine.GetVersion();
	}
}

TEST(StartSettings, VolumeBeatsTheDefaultFeature)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
	FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	OverridePostProcessSettings(Settings, BloomOf(2.0f), 0.5f);
	EXPECT_EQ(1.0f, Settings.BloomIntensity); // half way from 0, not from 0.675
}

TEST(OverrideSettings, NonFiniteValuesStayOut)
{
	FFinalPostProcessSettings Settings;
	OverridePostProcessSettings(Settings, BloomOf(std::nanf("")), 1.0f);
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(EndSettings, BloomQualityZeroSwitchesBloomOff)
{
	// The variable belongs to the bloom passes, which the library holds.
	const FScopedConsoleVariable Quality(TEXT("r.BloomQuality"), 0);
	FFinalPostProcessSettings Settings;
	EXPECT_EQ(
		"r.BloomQuality is 0", ReasonOf(EndFinalPostProcessSettings(Settings, FEngineShowFlags()), "BloomIntensity"));
	EXPECT_EQ(0.0f, Settings.BloomIntensity);
}

TEST(EndSettings, GrainNeedsTonemapperQualityFour)
{
	FFinalPostProcessSettings Settings;
	Settings.FilmGrainIntensity = 0.5f;
	const FScopedConsoleVariable Quality(TEXT("r.Tonemapper.Quality"), 3);
	EXPECT_EQ("r.Tonemapper.Quality is below 4",
		ReasonOf(EndFinalPostProcessSettings(Settings, FEngineShowFlags()), "FilmGrainIntensity"));
	EXPECT_EQ(0.0f, Settings.FilmGrainIntensity);
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
}

TEST(EndSettings, GrainStaysAtTonemapperQualityFour)
{
	FFinalPostProcessSettings Settings;
	Settings.FilmGrainIntensity = 0.5f;
	const FScopedConsoleVariable Quality(TEXT("r.Tonemapper.Quality"), 4);
	EndFinalPostProcessSettings(Settings, FEngineShowFlags());
	EXPECT_EQ(0.5f, Settings.FilmGrainIntensity);
}

TEST(EndSettings, FlagsSwitchOffGrainFlaresAndOcclusion)
{
	FFinalPostProcessSettings Settings;
	Settings.FilmGrainIntensity = 1.0f;
	FEngineShowFlags Flags;
	Flags.SetGrain(false);
	Flags.SetLensFlares(false);
	Flags.SetAmbientOcclusion(false);
	EXPECT_EQ(3u, EndFinalPostProcessSettings(Settings, Flags).size());
	EXPECT_EQ(0.0f, Settings.FilmGrainIntensity + Settings.LensFlareIntensity + Settings.AmbientOcclusionIntensity);
}

TEST(EndSettings, DepthOfFieldEndsByVariableOrFlag)
{
	FFinalPostProcessSettings ByVariable;
	ByVariable.DepthOfFieldScale = 1.0f;
	{
		const FScopedConsoleVariable Quality(TEXT("r.DepthOfFieldQuality"), 0);
		EndFinalPostProcessSettings(ByVariable, FEngineShowFlags());
	}
	FFinalPostProcessSettings ByFlag;
	ByFlag.DepthOfFieldScale = 1.0f;
	FEngineShowFlags Flags;
	Flags.SetDepthOfField(false);
	EndFinalPostProcessSettings(ByFlag, Flags);
	EXPECT_EQ(0.0f, ByVariable.DepthOfFieldScale);
	EXPECT_EQ(0.0f, ByFlag.DepthOfFieldScale);
}

TEST(EndSettings, LocalExposureIsNeutralByVariableOrFlag)
{
	FFinalPostProcessSettings ByVariable;
	ByVariable.LocalExposureHighlightContrastScale = 0.5f;
	ByVariable.LocalExposureShadowContrastScale = 0.5f;
	ByVariable.LocalExposureDetailStrength = 2.0f;
	FFinalPostProcessSettings ByFlag = ByVariable;
	{
		const FScopedConsoleVariable Off(TEXT("r.LocalExposure"), 0);
		EXPECT_EQ(3u, EndFinalPostProcessSettings(ByVariable, FEngineShowFlags()).size());
	}
	FEngineShowFlags Flags;
	Flags.SetLocalExposure(false);
	EXPECT_EQ(3u, EndFinalPostProcessSettings(ByFlag, Flags).size());
	EXPECT_EQ(1.0f, ByVariable.LocalExposureHighlightContrastScale);
	EXPECT_EQ(1.0f, ByFlag.LocalExposureShadowContrastScale);
	EXPECT_EQ(1.0f, ByFlag.LocalExposureDetailStrength);
}

TEST(EndSettings, IndirectLightEndsWithItsFlag)
{
	FFinalPostProcessSettings Settings;
	FEngineShowFlags Flags;
	Flags.SetGlobalIllumination(false);
	EndFinalPostProcessSettings(Settings, Flags);
	EXPECT_EQ(0.0f, Settings.IndirectLightingIntensity);
	EXPECT_EQ(0.0f, Settings.IndirectLightingColor.R);
}

TEST(EndSettings, MotionBlurIsScaledWithinZeroAndFifty)
{
	const auto AmountWith = [](const char* Scale)
	{
		const FScopedConsoleVariable Variable(TEXT("r.MotionBlur.Scale"), FString(Scale));
		FFinalPostProcessSettings Settings;
		EndFinalPostProcessSettings(Settings, FEngineShowFlags());
		return Settings.MotionBlurAmount;
	};
	EXPECT_EQ(0.25f, AmountWith("0.5"));
	EXPECT_EQ(0.0f, AmountWith("-3"));
	EXPECT_EQ(25.0f, AmountWith("1000"));
}

TEST(EndSettings, MotionBlurVariablesReplaceTheSettings)
{
	const FScopedConsoleVariable Scale(TEXT("r.MotionBlur.Scale"), FString("0.5"));
	const FScopedConsoleVariable Amount(TEXT("r.MotionBlur.Amount"), FString("0.75"));
	const FScopedConsoleVariable Max(TEXT("r.MotionBlur.Max"), FString("0"));
	const FScopedConsoleVariable Rate(TEXT("r.MotionBlur.TargetFPS"), 60);
	FFinalPostProcessSettings Settings;
	EndFinalPostProcessSettings(Settings, FEngineShowFlags());
	EXPECT_EQ(0.75f, Settings.MotionBlurAmount);
	EXPECT_EQ(0.0f, Settings.MotionBlurMax);
	EXPECT_EQ(60, Settings.MotionBlurTargetFPS);
}

TEST(EndSettings, FringeBelowItsMaximumStays)
{
	FFinalPostProcessSettings Settings;
	Settings.SceneFringeIntensity = 1.0f;
	const FScopedConsoleVariable Max(TEXT("r.SceneColorFringe.Max"), FString("1.5"));
	EXPECT_TRUE(EndFinalPostProcessSettings(Settings, FEngineShowFlags()).empty());
	EXPECT_EQ(1.0f, Settings.SceneFringeIntensity);
}

TEST(EndSettings, FringeQualityZeroSwitchesItOff)
{
	FFinalPostProcessSettings Settings;
	Settings.SceneFringeIntensity = 1.0f;
	const FScopedConsoleVariable Quality(TEXT("r.SceneColorFringeQuality"), 0);
	EndFinalPostProcessSettings(Settings, FEngineShowFlags());
	EXPECT_EQ(0.0f, Settings.SceneFringeIntensity);
}

TEST(EndSettings, NoValueOfAVariableMakesASettingInfinite)
{
	FFinalPostProcessSettings Settings;
	Settings.AutoExposureBias = 3e38f;
	const FScopedConsoleVariable Offset(TEXT("r.ExposureOffset"), FString("3e38"));
	EXPECT_TRUE(EndFinalPostProcessSettings(Settings, FEngineShowFlags()).empty());
	EXPECT_EQ(3e38f, Settings.AutoExposureBias);
}

TEST(EndSettings, FlagsMayBeAppliedAgain)
{
	const FScopedConsoleVariable Offset(TEXT("r.ExposureOffset"), FString("0.5"));
	FFinalPostProcessSettings Settings;
	EndFinalPostProcessSettings(Settings, FEngineShowFlags());
	FEngineShowFlags Flags;
	Flags.SetBloom(false);
	EXPECT_EQ(2u, ApplyShowFlags(Settings, Flags).size());
	EXPECT_TRUE(ApplyShowFlags(Settings, Flags).empty());
	EXPECT_EQ(0.0f, Settings.BloomIntensity);
	EXPECT_EQ(1.5f, Settings.AutoExposureBias);
}

TEST(EndSettings, BloomIntensityAndThresholdAreNotClamped)
{
	FFinalPostProcessSettings Settings;
	Settings.BloomIntensity = 1000.0f;
	Settings.BloomThreshold = -5.0f;
	EndFinalPostProcessSettings(Settings, FEngineShowFlags());
	EXPECT_EQ(1000.0f, Settings.BloomIntensity);
	EXPECT_EQ(-5.0f, Settings.BloomThreshold);
}

TEST(ShowFlags, GameShowsEverythingOfThisList)
{
	const FEngineShowFlags Flags(ESFIM_Game);
	EXPECT_TRUE(Flags.Bloom && Flags.PostProcessing && Flags.Tonemapper && Flags.EyeAdaptation);
}

TEST(ShowFlags, All0ShowsNothing)
{
	const FEngineShowFlags Flags(ESFIM_All0);
	for (uint32 Index = 0; Index < static_cast<uint32>(GetShowFlagInfos().Num()); ++Index)
	{
		EXPECT_FALSE(Flags.GetSingleFlag(Index));
	}
}

TEST(ShowFlags, NamesAreFoundWithoutCase)
{
	EXPECT_EQ(1, FEngineShowFlags::FindIndexByName("bloom"));
	EXPECT_EQ(INDEX_NONE, FEngineShowFlags::FindIndexByName("Blom"));
}

TEST(ShowFlags, SingleFlagIsTheNamedOne)
{
	FEngineShowFlags Flags(ESFIM_Game);
	Flags.SetSingleFlag(static_cast<uint32>(FEngineShowFlags::FindIndexByName("Vignette")), false);
	EXPECT_FALSE(Flags.Vignette);
	EXPECT_TRUE(Flags.Bloom);
}
