// Which effects run, and why not. Conditions: the engine's.
#include <gtest/gtest.h>

#include "pipeline/EffectTestUtils.h"
#include "Config/ReadConfig.h"
#include "HAL/ConsoleVariableTools.h"
#include "Run/FinalSettings.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace
{

FViewSettings Chain(const std::string& ConfigText)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(ConfigText, "a.json", Diagnostics);
	EXPECT_FALSE(HasErrors(Diagnostics));
	return MakeViewSettings(Config);
}

FEffectDecision Decision(const std::string& ConfigText, const std::string& Name)
{
	return FindEffect(DecideEffects(Chain(ConfigText)), Name);
}

std::string Unbound(const std::string& Settings, const std::string& More = "")
{
	return R"({"volumes": [{"bUnbound": true, )" + More + R"("Settings": {)" + Settings + "}}]}";
}

} // namespace

TEST(EffectDecisions, OnePerEffectInOrderWithAReason)
{
	const std::vector<FEffectDecision> Decisions = DecideEffects(Chain("{}"));
	ASSERT_EQ(GetEffects().size(), Decisions.size());
	for (size_t Index = 0; Index < Decisions.size(); ++Index)
	{
		EXPECT_EQ(GetEffects()[Index], Decisions[Index].Effect);
		EXPECT_FALSE(Decisions[Index].Reason.empty()) << Decisions[Index].GetName();
	}
}

TEST(EffectDecisions, ConvolutionBloomSaysSo)
{
	EXPECT_EQ("BloomIntensity is 0.675, BloomThreshold -1: the setup pass is not needed; by convolution (BM_FFT), "
			  "BloomConvolutionScatterDispersion 1",
		Decision(Unbound(R"("BloomMethod": "BM_FFT")"), "Bloom").Reason);
	EXPECT_EQ(
		"BloomIntensity is 0.675, BloomThreshold 1; by convolution (BM_FFT), BloomConvolutionScatterDispersion 2; "
		"it reads no threshold",
		Decision(
			Unbound(R"("BloomMethod": "BM_FFT", "BloomThreshold": 1, "BloomConvolutionScatterDispersion": 2)"), "Bloom")
			.Reason);
}

TEST(EffectDecisions, ConvolutionBloomWithoutKernelFallsBack)
{
	const FEffectDecision Bloom =
		Decision(Unbound(R"("BloomMethod": "BM_FFT", "BloomConvolutionTexture": "/Game/Lens/Kernel.Kernel")"), "Bloom");
	EXPECT_TRUE(Bloom.bActive);
	EXPECT_EQ(
		"BloomIntensity is 0.675, BloomThreshold -1: the setup pass is not needed; BM_FFT is asked for, but there "
		"are no pixels for BloomConvolutionTexture /Game/Lens/Kernel.Kernel: the Gaussian sum runs",
		Bloom.Reason);
}

TEST(EffectDecisions, DefaultsHaveBloomWithoutSetup)
{
	const FEffectDecision Bloom = Decision("{}", "Bloom");
	EXPECT_TRUE(Bloom.bActive);
	EXPECT_EQ("BloomIntensity is 0.675, BloomThreshold -1: the setup pass is not needed", Bloom.Reason);
}

TEST(EffectDecisions, ZeroIntensityHasNoBloom)
{
	const FEffectDecision Bloom = Decision(Unbound(R"("BloomIntensity": 0)"), "Bloom");
	EXPECT_FALSE(Bloom.bActive);
	EXPECT_FALSE(Bloom.bConfigured);
	EXPECT_EQ("BloomIntensity is 0", Bloom.Reason);
}

TEST(EffectDecisions, NegativeIntensityHasNoBloom)
{
	EXPECT_FALSE(Decision(Unbound(R"("BloomIntensity": -1)"), "Bloom").bActive);
}

TEST(EffectDecisions, BloomThatAFlagSwitchesOffSaysWhich)
{
	const FEffectDecision Bloom =
		Decision(R"({"showFlags": {"Bloom": false}, "camera": {"Settings": {"BloomIntensity": 2}}})", "Bloom");
	EXPECT_EQ("BloomIntensity is 0: ShowFlag.Bloom is off", Bloom.Reason);
	EXPECT_TRUE(Bloom.bConfigured);
}

TEST(EffectDecisions, PostProcessingOffHasNoBloom)
{
	EXPECT_EQ(
		"ShowFlag.PostProcessing is off", Decision(R"({"showFlags": {"PostProcessing": false}})", "Bloom").Reason);
}

TEST(EffectDecisions, ToonBloomRunsWhereItsSettingIsNamed)
{
	const FEffectDecision ToonBloom = Decision(Unbound(R"("BloomToonIntensity": 0.1)"), "ToonBloom");
	EXPECT_TRUE(ToonBloom.bConfigured);
	EXPECT_TRUE(ToonBloom.bActive);
	EXPECT_EQ("BloomToonIntensity is 0.1: it brings the setup pass into the graph", ToonBloom.Reason);
	EXPECT_EQ("BloomIntensity is 0.675, BloomThreshold -1: the setup pass is there for the toon's factor",
		Decision(Unbound(R"("BloomToonIntensity": 0.1)"), "Bloom").Reason);
}

TEST(EffectDecisions, ToonBloomUncalledForSaysThatThereIsNoSetupPass)
{
	const FEffectDecision ToonBloom = Decision("{}", "ToonBloom");
	EXPECT_FALSE(ToonBloom.bActive);
	EXPECT_FALSE(ToonBloom.bConfigured);
	EXPECT_EQ("not called for: nothing names BloomToonIntensity; without it the bloom setup pass is not in the graph "
			  "(BloomThreshold is -1)",
		ToonBloom.Reason);
	EXPECT_EQ("not called for: nothing names BloomToonIntensity",
		Decision(Unbound(R"("BloomThreshold": 0)"), "ToonBloom").Reason);
}

TEST(EffectDecisions, ToonBloomIsCalledForByAVolumeWithoutWeight)
{
	EXPECT_TRUE(Decision(Unbound(R"("BloomToonIntensity": 0.1)", R"("BlendWeight": 0, )"), "ToonBloom").bActive);
}

TEST(EffectDecisions, ToonBloomIsCalledForByAnExtensionThatSetsItsOverrideBit)
{
	FViewSettings Edited = Chain("{}");
	Edited.Settings.bOverride_BloomToonIntensity = true;
	EXPECT_TRUE(IsEffectActive(DecideEffects(Edited), EEffect::ToonBloom));
}

TEST(EffectDecisions, ToonBloomIsZeroWhereTheDefaultFeatureIsOffAndOnlyBloomIsBroughtBack)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
	const FEffectDecision ToonBloom = Decision(Unbound(R"("BloomIntensity": 1, "BloomThreshold": 0)"), "ToonBloom");
	EXPECT_TRUE(ToonBloom.bActive);
	EXPECT_TRUE(ToonBloom.bConfigured);
	EXPECT_EQ("BloomToonIntensity is 0, though nothing names it", ToonBloom.Reason);
}

TEST(EffectDecisions, ToonBloomIsNotMissedWhereBloomIsOff)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
	EXPECT_FALSE(Decision("{}", "ToonBloom").bActive);
	EXPECT_FALSE(Decision("{}", "ToonBloom").bConfigured);
	EXPECT_FALSE(Decision(R"({"showFlags": {"Bloom": false}})", "ToonBloom").bConfigured);
}

TEST(EffectDecisions, ToonBloomOfFactorOneChangesNothing)
{
	const FEffectDecision ToonBloom = Decision(Unbound(R"("BloomToonIntensity": 1, "BloomThreshold": 0)"), "ToonBloom");
	EXPECT_FALSE(ToonBloom.bActive);
	EXPECT_TRUE(ToonBloom.bConfigured);
	EXPECT_EQ("BloomToonIntensity is 1, which changes nothing", ToonBloom.Reason);
}

TEST(EffectDecisions, ToonBloomFollowsItsVariable)
{
	{
		const FScopedConsoleVariable Always(TEXT("r.ToonBloom"), 1);
		EXPECT_TRUE(Decision("{}", "ToonBloom").bActive);
	}
	const FScopedConsoleVariable Never(TEXT("r.ToonBloom"), 0);
	const FEffectDecision ToonBloom =
		Decision(Unbound(R"("BloomToonIntensity": 0.1, "BloomThreshold": 0)"), "ToonBloom");
	EXPECT_FALSE(ToonBloom.bActive);
	EXPECT_EQ("r.ToonBloom is 0", ToonBloom.Reason);
}

TEST(EffectDecisions, ToonBloomNeedsBloom)
{
	EXPECT_EQ("there is no bloom to mask: BloomIntensity is 0",
		Decision(Unbound(R"("BloomToonIntensity": 0.1, "BloomIntensity": 0)"), "ToonBloom").Reason);
}

TEST(EffectDecisions, ToonBloomAsPrintedIsLostInCompute)
{
	const FScopedConsoleVariable AsPrinted(TEXT("r.ToonBloom.AsPrinted"), 1);
	const std::string Text = Unbound(R"("BloomToonIntensity": 0.5, "BloomThreshold": 0)");
	EXPECT_EQ("BloomToonIntensity is 0.5; as printed: one id for each half-resolution pixel",
		Decision(Text, "ToonBloom").Reason);
	const FScopedConsoleVariable Compute(TEXT("r.PostProcessing.PreferCompute"), 1);
	EXPECT_NE(std::string::npos, Decision(Text, "ToonBloom").Reason.find("lost"));
}

TEST(EffectDecisions, AntiAliasingFollowsItsVariable)
{
	EXPECT_EQ("r.AntiAliasingMethod is 0", Decision("{}", "FXAA").Reason);
	EXPECT_EQ("r.AntiAliasingMethod is 0", Decision("{}", "TemporalAA").Reason);
	{
		const FScopedConsoleVariable Method(TEXT("r.AntiAliasingMethod"), 5);
		EXPECT_EQ("r.AntiAliasingMethod is 5, which is not simulated", Decision("{}", "FXAA").Reason);
		EXPECT_TRUE(Decision("{}", "FXAA").bConfigured);
		EXPECT_FALSE(Decision("{}", "TemporalAA").bConfigured);
	}
	{
		const FScopedConsoleVariable Method(TEXT("r.AntiAliasingMethod"), 2);
		EXPECT_EQ("r.AntiAliasingMethod is 2", Decision("{}", "FXAA").Reason);
		EXPECT_FALSE(Decision("{}", "FXAA").bConfigured);
		EXPECT_EQ(
			"r.AntiAliasingMethod is 2, r.TemporalAACurrentFrameWeight 0.04", Decision("{}", "TemporalAA").Reason);
		EXPECT_TRUE(Decision("{}", "TemporalAA").bActive);
		EXPECT_EQ(
			"ShowFlag.AntiAliasing is off", Decision(R"({"showFlags": {"AntiAliasing": false}})", "TemporalAA").Reason);
		EXPECT_EQ(
			"ShowFlag.TemporalAA is off", Decision(R"({"showFlags": {"TemporalAA": false}})", "TemporalAA").Reason);
	}
	const FScopedConsoleVariable Method(TEXT("r.AntiAliasingMethod"), 4);
	EXPECT_EQ("r.AntiAliasingMethod is 4 (TSR), for which temporal antialiasing stands in, "
			  "r.TemporalAACurrentFrameWeight 0.04",
		Decision("{}", "TemporalAA").Reason);
}

TEST(EffectDecisions, FxaaRunsWhereItIsChosenAndNotSwitchedOff)
{
	const FScopedConsoleVariable Method(TEXT("r.AntiAliasingMethod"), 1);
	EXPECT_TRUE(Decision("{}", "FXAA").bActive);
	EXPECT_EQ("r.AntiAliasingMethod is 1, r.FXAA.Quality 4", Decision("{}", "FXAA").Reason);
	EXPECT_EQ("ShowFlag.AntiAliasing is off", Decision(R"({"showFlags": {"AntiAliasing": false}})", "FXAA").Reason);
	EXPECT_FALSE(Decision(R"({"showFlags": {"PostProcessing": false}})", "FXAA").bActive);
}

TEST(EffectDecisions, UpscaleRunsAtAnotherSizeThanTheOutputs)
{
	EXPECT_EQ("scene.screenPercentage is 100", Decision("{}", "Upscale").Reason);
	const std::string Half = R"("scene": {"file": "a.exr", "screenPercentage": 50})";
	EXPECT_TRUE(Decision("{" + Half + "}", "Upscale").bActive);
	EXPECT_EQ("scene.screenPercentage is 50, r.Upscale.Quality 3", Decision("{" + Half + "}", "Upscale").Reason);
	EXPECT_FALSE(Decision("{" + Half + R"(, "showFlags": {"ScreenPercentage": false}})", "Upscale").bActive);
}

TEST(EffectDecisions, TonemapSaysHow)
{
	EXPECT_EQ("always; by the combined table", Decision("{}", "Tonemap").Reason);
	EXPECT_EQ("always; by the combined table, with colour grading",
		Decision(Unbound(R"("WhiteTemp": 5000)"), "Tonemap").Reason);
	const FScopedConsoleVariable Analytic(TEXT("r.Drydock.TonemapLUT"), 0);
	const FScopedConsoleVariable Device(TEXT("r.HDR.Display.OutputDevice"), 3);
	EXPECT_EQ("always; evaluated for each pixel, for ST 2084, Rec.2020", Decision("{}", "Tonemap").Reason);
	EXPECT_EQ("always; gamma only, no curve, bloom or lens: ShowFlag.Tonemapper is off",
		Decision(R"({"showFlags": {"Tonemapper": false}})", "Tonemap").Reason);
}

TEST(EffectDecisions, TonemapAlwaysRuns)
{
	EXPECT_TRUE(Decision(R"({"showFlags": {"PostProcessing": false}})", "Tonemap").bActive);
}

TEST(FinalSettings, HigherPriorityIsAppliedLastWhateverTheOrderOfTheFile)
{
	const FViewSettings Result = Chain(R"({"volumes": [
		{"bUnbound": true, "Priority": 2, "Settings": {"BloomIntensity": 2}},
		{"bUnbound": true, "Priority": 1, "Settings": {"BloomIntensity": 1}}]})");
	EXPECT_EQ(2.0f, Result.Settings.BloomIntensity);
}

TEST(FinalSettings, WeightsLerpInSequence)
{
	const FViewSettings Result = Chain(R"({"volumes": [
		{"bUnbound": true, "Priority": 1, "Settings": {"BloomSizeScale": 8}},
		{"bUnbound": true, "Priority": 2, "BlendWeight": 0.25, "Settings": {"BloomSizeScale": 16}}]})");
	EXPECT_EQ(8.0f + 0.25f * 8.0f, Result.Settings.BloomSizeScale);
}

TEST(FinalSettings, DisabledVolumesDoNothing)
{
	EXPECT_EQ(
		0.675f, Chain(R"({"volumes": [{"bUnbound": true, "bEnabled": false, "Settings": {"BloomIntensity": 2}}]})")
					.Settings.BloomIntensity);
}

TEST(FinalSettings, BoundedVolumesActWhereTheViewIs)
{
	const auto IntensityAt = [](const std::string& X)
	{
		return Chain(R"({"view": {"location": [)" + X + R"(, 0, 0]}, "volumes": [
			{"bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 50}, "Settings": {"BloomIntensity": 2.675}}]})")
			.Settings.BloomIntensity;
	};
	EXPECT_EQ(2.675f, IntensityAt("50"));
	EXPECT_FLOAT_EQ(1.675f, IntensityAt("100")); // 50 away of a radius of 100: half
	EXPECT_EQ(0.675f, IntensityAt("150"));
}

TEST(FinalSettings, EqualPrioritiesWarnWhereTheyDisagree)
{
	const auto Warnings = [](const std::string& Second)
	{
		std::vector<FDiagnostic> Diagnostics;
		const FConfig Config = ReadConfig(R"({"volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 2}},
{)" + Second + "}]}",
			"a.json", Diagnostics);
		MakeViewSettings(Config, &Diagnostics);
		return Diagnostics;
	};
	const std::vector<FDiagnostic> Found = Warnings(R"("bUnbound": true, "Settings": {"BloomIntensity": 3})");
	ASSERT_EQ(1u, Found.size());
	EXPECT_EQ("a.json:2:1: warning DD1017 at /volumes/1: same Priority as volumes/0, and both act here: the order of "
			  "declaration decides BloomIntensity",
		Found[0].ToString());
	EXPECT_TRUE(Warnings(R"("bUnbound": true, "Settings": {"BloomIntensity": 2})").empty());
	EXPECT_TRUE(Warnings(R"("bUnbound": true, "Settings": {"BloomSizeScale": 2})").empty());
	EXPECT_TRUE(Warnings(R"("bUnbound": true, "Priority": 1, "Settings": {"BloomIntensity": 3})").empty());
	EXPECT_TRUE(Warnings(R"("bUnbound": true, "bEnabled": false, "Settings": {"BloomIntensity": 3})").empty());
}

TEST(FinalSettings, CameraComesAfterVolumesWithItsWeight)
{
	const FViewSettings Result = Chain(R"({"volumes": [{"bUnbound": true, "Settings": {"BloomSizeScale": 8}}],
		"camera": {"PostProcessBlendWeight": 0.5, "Settings": {"BloomSizeScale": 2}}})");
	EXPECT_EQ(5.0f, Result.Settings.BloomSizeScale);
}

TEST(FinalSettings, ExposureScaleIsOneAtDefaults)
{
	EXPECT_EQ(1.0f, Chain("{}").ExposureScale);
}

TEST(FinalSettings, OneMoreBiasDoublesTheExposure)
{
	EXPECT_EQ(2.0f, Chain(Unbound(R"("AutoExposureBias": 2)")).ExposureScale);
	EXPECT_EQ(
		0.75f, Chain(R"({"view": {"exposure": 3}, "camera": {"Settings": {"AutoExposureBias": -1}}})").ExposureScale);
}

TEST(FinalSettings, ExposureIsOneWithoutEyeAdaptation)
{
	EXPECT_EQ(1.0f, Chain(R"({"view": {"exposure": 3}, "showFlags": {"EyeAdaptation": false}})").ExposureScale);
}

TEST(FinalSettings, NamedSettingsAreThoseOfAllSourcesOnce)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfig Config = ReadConfig(R"({"volumes": [{"bUnbound": true, "Settings": {"FilmToe": 0.5, "BloomIntensity": 1}}],
		"camera": {"Settings": {"BloomIntensity": 2}}})",
		"a.json", Diagnostics);
	AddSettingArgument(Config, "FilmSlope=0.9", Diagnostics);
	EXPECT_EQ((std::vector<std::string>{"BloomIntensity", "FilmSlope", "FilmToe"}), GetNamedSettings(Config));
}

TEST(EffectDecisions, ArticleEffectsAreNeutralByDefault)
{
	for (const char* Name : {"RED", "REDDepthOfField", "CharaGlow", "ToonShadowBlur", "UnityBloom"})
	{
		EXPECT_FALSE(Decision("{}", Name).bActive) << Name;
		EXPECT_FALSE(Decision("{}", Name).bConfigured) << Name;
	}
	EXPECT_EQ(
		"UnityBloomIntensity is 0: neutral, and nothing in the config sets it", Decision("{}", "UnityBloom").Reason);
}

TEST(EffectDecisions, ArticleEffectRunsWhereItsSwitchIsNotNeutral)
{
	const FEffectDecision Red = Decision(Unbound(R"("GlowIntensity": 0.5)"), "RED");
	EXPECT_TRUE(Red.bActive);
	EXPECT_EQ("DiffusionFilterIntensity is 0, SoftFocusBlend 0, SoftFocusSaturation 1, GlowIntensity 0.5; before "
			  "separate translucency",
		Red.Reason);
	EXPECT_TRUE(Decision(Unbound(R"("SoftFocusSaturation": 0.5)"), "RED").bActive);
	EXPECT_TRUE(Decision(Unbound(R"("CharaGlowArea": 4)"), "CharaGlow").bActive);
	EXPECT_TRUE(Decision(Unbound(R"("REDDofFocalDistance": 300)"), "REDDepthOfField").bActive);
	EXPECT_TRUE(Decision(Unbound(R"("ToonShadowBlurIntensity": 1)"), "ToonShadowBlur").bActive);
	EXPECT_TRUE(Decision(Unbound(R"("UnityBloomIntensity": 1)"), "UnityBloom").bActive);
}

TEST(EffectDecisions, ArticleEffectNamedButNeutralIsConfiguredAndDoesNotRun)
{
	const FEffectDecision Glow = Decision(Unbound(R"("CharaGlowColor": [1, 0, 0, 1])"), "CharaGlow");
	EXPECT_FALSE(Glow.bActive);
	EXPECT_TRUE(Glow.bConfigured);
	EXPECT_EQ("CharaGlowArea is 0: neutral", Glow.Reason);
}

TEST(EffectDecisions, ArticleEffectsNeedPostProcessing)
{
	const std::string Config =
		R"({"showFlags": {"PostProcessing": false}, "volumes": [{"bUnbound": true, "Settings": {"GlowIntensity": 1}}]})";
	EXPECT_FALSE(Decision(Config, "RED").bActive);
	EXPECT_EQ("ShowFlag.PostProcessing is off", Decision(Config, "RED").Reason);
}

TEST(EffectDecisions, PlaceOfRedIsTold)
{
	const FScopedConsoleVariable Place(TEXT("r.REDPostprocessAfterTranslucency"), FString(TEXT("2")));
	EXPECT_TRUE(Decision(Unbound(R"("GlowIntensity": 0.5)"), "RED").Reason.ends_with("; after bloom"));
}

TEST(EffectDecisions, FFTBloomIsAnEffectOfItsOwn)
{
	EXPECT_EQ("BloomMethod is BM_SOG", Decision("{}", "FFTBloom").Reason);
	EXPECT_TRUE(Decision(Unbound(R"("BloomMethod": "BM_FFT")"), "FFTBloom").bActive);
	EXPECT_EQ("there is no bloom: BloomIntensity is 0",
		Decision(Unbound(R"("BloomMethod": "BM_FFT", "BloomIntensity": 0)"), "FFTBloom").Reason);
}

TEST(EffectDecisions, AnEffectThatAViewExtensionMakesSaysSo)
{
	const FViewSettings View = Chain("{}");
	const std::vector<std::string> Extensions = {"FDualKawaseBlur"};
	const std::vector<FEffectDecision> Effects = DecideEffects({View.Settings, View, Extensions});
	EXPECT_TRUE(FindEffect(Effects, "DualKawaseBlur").bByExtension);
	EXPECT_EQ("a view extension makes it", FindEffect(Effects, "DualKawaseBlur").Reason);
}

TEST(EffectDecisions, WhereTheSceneIsNotLookedAtWhoAskedSaysWhy)
{
	const FViewSettings View =
		Chain(Unbound(R"("BloomToonIntensity": 0.1, "MotionBlurMax": 5, "UnityBloomIntensity": 1)"));
	const std::vector<FEffectDecision> Noted = NoteContentUnseen(View, DecideBySettings(View), "nobody looks");
	EXPECT_TRUE(FindEffect(Noted, "ToonBloom").Reason.ends_with("; nobody looks"));
	EXPECT_TRUE(FindEffect(Noted, "MotionBlur").Reason.ends_with("; nobody looks"));
	EXPECT_FALSE(FindEffect(Noted, "UnityBloom").Reason.ends_with("; nobody looks")); // the scene says nothing of it
}
