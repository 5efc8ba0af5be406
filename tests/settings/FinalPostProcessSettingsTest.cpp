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
