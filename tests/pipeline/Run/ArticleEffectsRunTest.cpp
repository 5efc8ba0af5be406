// The articles' effects in whole frames: where they run, what they read and report, and that a config can build the
// same chain pass by pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/EffectTestUtils.h"
#include "PassFactory.h"
#include "Run/Run.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace
{

FRunResult RunText(const std::string& Settings, const std::string& More = "",
	const std::vector<std::string>& Variables = {}, bool bDouble = false)
{
	FRunOptions Options;
	Options.bDouble = bDouble;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/text.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "volumes": [{"bUnbound": true, "Settings": {)" +
		Settings + "}}]" + More + "}";
	Options.Variables = Variables;
	Options.bMeasureEffects = true;
	return RunConfig(Options);
}

/** Position of the first pass whose name begins so; -1 where there is none. */
int FindPass(const FRunResult& Result, const std::string& Begin)
{
	const auto& Passes = Result.Graph.Passes;
	const auto Found = std::find_if(
		Passes.begin(), Passes.end(), [&](const FRDGCompiledPass& Pass) { return Pass.Name.starts_with(Begin); });
	return Found == Passes.end() ? -1 : static_cast<int>(Found - Passes.begin());
}

std::vector<std::string> GetDecoded(const FRunResult& Result)
{
	std::vector<std::string> Names;
	for (const FSceneChannel& Channel : Result.Channels)
	{
		if (Channel.bDecoded)
		{
			Names.push_back(Channel.Name);
		}
	}
	return Names;
}

FEffectFigures MeasureToonShadow(const std::string& Store, bool bDouble = false)
{
	const FRunResult Result =
		RunText(R"("ToonShadowBlurIntensity": 1, "ToonShadowBlurStore": ")" + Store + R"(")", "", {}, bDouble);
	return FindFigures(Result, EEffect::ToonShadowBlur);
}

double CountDarkLevels(const std::string& Store)
{
	return MeasureToonShadow(Store).Get("banding", "darkLevels");
}

} // namespace

TEST(ArticleEffectsRun, NeutralSettingsAreTheIdentityBitForBit)
{
	const FRunResult Neutral = RunText(R"("DiffusionFilterIntensity": 0, "DiffusionFilterPower": 3, "SoftFocusBlend": 0,
		"SoftFocusSaturation": 1, "GlowIntensity": 0, "CharaGlowArea": 0, "CharaGlowColor": [1, 0, 0, 1],
		"REDDofFocalDistance": 0, "ToonShadowBlurIntensity": 0, "ToonShadowBlurSizeScale": 4, "UnityBloomIntensity": 0,
		"UnityBloomThreshold": 0, "DualKawaseBlurPassNum": 0)");
	const FRunResult Plain = RunText("");
	EXPECT_EQ(Plain.Final.ToImage().Values, Neutral.Final.ToImage().Values);
	EXPECT_EQ(Plain.Graph.Passes.size(), Neutral.Graph.Passes.size());
}

TEST(ArticleEffectsRun, AsPrintedTheBlurOfRedIsWarnedOf)
{
	const FRunResult Result = RunText(R"("GlowIntensity": 0.5)", "", {"r.RED.AsPrinted=1"});
	EXPECT_THAT(Result.RunJson, testing::HasSubstr("\"DD2100\""));
	EXPECT_THAT(Result.RunJson, testing::HasSubstr("1.9952"));
	EXPECT_THAT(RunText(R"("GlowIntensity": 0.5)").RunJson, testing::Not(testing::HasSubstr("DD2100")));
}

TEST(ArticleEffectsRun, RedFollowsBloomWhereItIsPutThere)
{
	const std::string Settings = R"("GlowIntensity": 0.5)";
	const FRunResult Before = RunText(Settings);
	EXPECT_LT(FindPass(Before, "RED.Glow"), FindPass(Before, "Bloom1Y"));
	const FRunResult After = RunText(Settings, "", {"r.REDPostprocessAfterTranslucency=2"});
	EXPECT_GT(FindPass(After, "BloomComposite"), FindPass(After, "Bloom1Y"));
	EXPECT_GT(FindPass(After, "RED.Glow"), FindPass(After, "BloomComposite"));
}

TEST(ArticleEffectsRun, BloomCompositedBeforeTheTonemapperGivesThePictureOfBloomAddedInIt)
{
	// A glow of no strength: the chain after bloom without a change of its own.
	const FRunResult Plain = RunText(R"("BloomIntensity": 1)");
	const FRunResult Composited = RunText(R"("BloomIntensity": 1, "CharaGlowArea": 1, "CharaGlowColor": [1, 1, 1, 0])",
		"", {"r.REDPostprocessAfterTranslucency=2"});
	ASSERT_GE(FindPass(Composited, "BloomComposite"), 0);
	double Largest = 0;
	const FImage PlainFinal = Plain.Final.ToImage();
	const FImage CompositedFinal = Composited.Final.ToImage();
	for (size_t Index = 0; Index < PlainFinal.Values.size(); ++Index)
	{
		Largest = std::max(Largest, std::abs(PlainFinal.Values[Index] - CompositedFinal.Values[Index]));
	}
	EXPECT_LE(Largest, 1.01 / 255); // the composite is stored in half once more
}

TEST(ArticleEffectsRun, UnityBloomAfterTheTonemapperWritesTheOutput)
{
	const std::string Settings = R"("BloomIntensity": 0, "UnityBloomIntensity": 1)";
	const FRunResult Before = RunText(Settings);
	EXPECT_LT(FindPass(Before, "UnityBloom.Composite"), FindPass(Before, "Tonemap"));
	const FRunResult After = RunText(Settings, "", {"r.UnityBloom.Insertion=1"});
	EXPECT_GT(FindPass(After, "UnityBloom.Composite"), FindPass(After, "Tonemap"));
	EXPECT_NE(Before.Final.ToImage().Values, After.Final.ToImage().Values);
	EXPECT_NE(RunText(R"("BloomIntensity": 0)").Final.ToImage().Values, After.Final.ToImage().Values);
}

TEST(ArticleEffectsRun, EachEffectDecodesOnlyItsChannels)
{
	using testing::Contains;
	using testing::Not;
	const std::vector<std::string> Glow = GetDecoded(RunText(R"("CharaGlowArea": 3)"));
	EXPECT_THAT(Glow, Contains("custommask.B"));
	EXPECT_THAT(Glow, Not(Contains("depth.Z")));
	const std::vector<std::string> Dof = GetDecoded(RunText(R"("REDDofFocalDistance": 400)"));
	EXPECT_THAT(Dof, Contains("depth.Z"));
	EXPECT_THAT(Dof, Not(Contains("custommask.B")));
	const std::vector<std::string> Shadow = GetDecoded(RunText(R"("ToonShadowBlurIntensity": 1)"));
	EXPECT_THAT(Shadow, testing::IsSupersetOf({"shadow.R", "shadow.G", "basecolor.R", "shadingmodel.ID"}));
}

TEST(ArticleEffectsRun, SquareRootKeepsMoreDarkLevels)
{
	// Below 1/20 lie 13 levels of 8 bit, and 57 squares of them.
	EXPECT_LE(CountDarkLevels("SixteenBit"), 13u);
	EXPECT_LE(CountDarkLevels("EightBit"), 13u);
	EXPECT_GE(CountDarkLevels("SqrtEightBit"), 26u);
}

TEST(ArticleEffectsRun, DeviationOrdersTheThreeStores)
{
	// In steps of 1/255: one rounding to 8 bit leaves 0.29, two that know nothing of each other sqrt(2) times that, and
	// twenty passes in 8 bit more; the root, below 1/20, at most 2 * sqrt(1/20) of 0.29.
	const FEffectFigures Mosaic = MeasureToonShadow("EightBit");
	const FEffectFigures Bands = MeasureToonShadow("SixteenBit");
	const FEffectFigures Smooth = MeasureToonShadow("SqrtEightBit");
	EXPECT_GT(Mosaic.Get("darkDeviation", "rms"), 0.29 * std::sqrt(2));
	EXPECT_NEAR(0.29, Bands.Get("darkDeviation", "rms"), 0.03);
	EXPECT_LT(Smooth.Get("darkDeviation", "rms"), 0.29 * 2 * std::sqrt(0.05));
	EXPECT_GT(Mosaic.Get("darkDeviation", "largest"), 2 * Bands.Get("darkDeviation", "largest"));
	EXPECT_GT(Bands.Get("darkDeviation", "largest"), Smooth.Get("darkDeviation", "largest"));
	EXPECT_EQ(Mosaic.Get("darkDeviation", "texels"), Smooth.Get("darkDeviation", "texels"));
}

TEST(ArticleEffectsRun, WithoutRoundingNothingDeviates)
{
	EXPECT_LT(MeasureToonShadow("EightBit", true).Get("darkDeviation", "largest"), 1e-3);
}

TEST(ArticleEffectsRun, ToonShadowPassByPassIsTheEffect)
{
	const FRunResult BySettings = RunText(R"("ToonShadowBlurIntensity": 0.5, "ToonShadowBlurSizeScale": 2)");
	// The scene's light is (11, 10.01, 8.8).
	const FRunResult ByPasses = RunText("", R"(, "passes": [
		{"type": "ToonShadowSetup", "at": "MotionBlur", "name": "Setup", "replace": false},
		{"type": "TextureBlur", "at": "MotionBlur", "name": "Blur", "replace": false, "inputs": {"Input": "Setup"},
			"parameters": {"SizeScale": 2}},
		{"type": "ToonShadowCombine", "at": "MotionBlur", "name": "Buffer", "replace": false, "inputs": {"Blurred": "Blur"}},
		{"type": "ToonShadowLighting", "at": "MotionBlur", "inputs": {"Shadow": "Buffer"},
			"parameters": {"Intensity": 0.5, "LightColor": [1, 0.91, 0.8]}}])");
	EXPECT_NE(RunText("").Final.ToImage().Values, BySettings.Final.ToImage().Values);
	EXPECT_EQ(BySettings.Final.ToImage().Values, ByPasses.Final.ToImage().Values);
}

TEST(ArticleEffectsRun, DepthOfFieldByNameIsTheEffect)
{
	const FRunResult BySettings = RunText(R"("REDDofFocalDistance": 400, "REDDofFarBlurSize": 4)");
	const FRunResult ByPass = RunText("", R"(, "passes": [{"type": "REDDepthOfField", "at": "MotionBlur",
		"parameters": {"FocalDistance": 400, "FarBlurSize": 4}}])");
	EXPECT_EQ(BySettings.Final.ToImage().Values, ByPass.Final.ToImage().Values);
}

TEST(ArticleEffectsRun, EveryPassOfTheEffectsRunsAtEveryHook)
{
	const std::vector<std::string> Prefixes = {
		"RED", "CharaGlow", "ToonShadow", "TextureBlur", "UnityBloom", "DualKawase"};
	for (const auto& [Hook, Engine] : {std::pair("PrePostProcessPass", "5.4"), {"MotionBlur", "5.4"},
			 {"SSRInput", "5.4"}, {"Tonemap", "5.4"}, {"BeforeDOF", "5.5"}, {"AfterDOF", "5.5"}})
	{
		// Each pass makes a picture that a glow then shows, whatever its size is, so that none is culled.
		std::string Passes;
		int NumPasses = 0;
		for (const FPassFactory* Factory : GetPassFactories())
		{
			if (std::none_of(Prefixes.begin(), Prefixes.end(),
					[&](const std::string& Prefix) { return Factory->Type.starts_with(Prefix); }))
			{
				continue;
			}
			std::string Inputs;
			for (const FPassInputSpec& Input : Factory->Inputs)
			{
				Inputs +=
					Input.Default.empty() ? (Inputs.empty() ? "\"" : ", \"") + Input.Name + "\": \"SceneColor\"" : "";
			}
			const std::string Name = "Pass" + std::to_string(NumPasses++);
			const std::string At = std::string("\", \"at\": \"") + Hook + "\"";
			Passes += (Passes.empty() ? "" : ", ") + ("{\"type\": \"" + Factory->Type + At) + ", \"name\": \"" + Name +
					  "\", \"replace\": false, \"inputs\": {" + Inputs + "}}, {\"type\": \"REDGlow" + At +
					  ", \"parameters\": {\"Intensity\": 0.01}, \"inputs\": {\"Blurred\": \"" + Name + "\"}}";
		}
		const FRunResult Result =
			RunText("", std::string(R"(, "engine": ")") + Engine + R"(", "passes": [)" + Passes + "]");
		EXPECT_EQ(19, NumPasses);
		const auto NumGlows = std::count_if(Result.Graph.Passes.begin(), Result.Graph.Passes.end(),
			[](const FRDGCompiledPass& Pass) { return Pass.Name.starts_with("RED.Glow"); });
		EXPECT_EQ(NumPasses + 1, NumGlows) << Hook; // the glow is one of the passes itself
		const FImage ResultFinal = Result.Final.ToImage();
		EXPECT_TRUE(std::all_of(ResultFinal.Values.begin(), ResultFinal.Values.end(),
			[](double Value) { return Value >= 0 && Value <= 1; }))
			<< Hook;
	}
}

TEST(ArticleEffectsRun, TextureBlurWorksOnAnyPictureAtAnyHook)
{
	for (const char* Hook : {"MotionBlur", "Tonemap", "PrePostProcessPass"})
	{
		const FRunResult Result = RunText("", R"(, "passes": [
			{"type": "TextureBlur", "at": ")" + std::string(Hook) +
												  R"(", "name": "B", "replace": false},
			{"type": "REDGlow", "at": ")" + Hook + R"(", "inputs": {"Blurred": "B"}}])");
		EXPECT_NE(RunText("").Final.ToImage().Values, Result.Final.ToImage().Values) << Hook;
	}
}

TEST(ArticleEffectsRun, LightHasTheColorOfTheScene)
{
	const FRunResult Result = RunText(R"("ToonShadowBlurIntensity": 1)");
	EXPECT_NEAR(10.01 / 11, Result.LightColor.G, 1e-6);
	EXPECT_NEAR(8.8 / 11, Result.LightColor.B, 1e-6);
	EXPECT_THAT(Result.RunJson, testing::HasSubstr("\"lightColor\": [1, 0.91, 0.8]"));
}

TEST(ArticleEffectsRun, ReportHoldsBandingAndTheMapIsThere)
{
	const FRunResult Result = RunText(R"("ToonShadowBlurIntensity": 1)");
	EXPECT_THAT(Result.RunJson, testing::HasSubstr("\"uniqueLevels\""));
	EXPECT_THAT(Result.RunJson, testing::HasSubstr("\"darkDeviation\": {\"rms\": "));
	const std::vector<FEffectPicture> Pictures = FindFigures(Result, EEffect::ToonShadowBlur).Pictures;
	ASSERT_EQ(2u, Pictures.size());
	EXPECT_EQ(641, Pictures[0].Image.Width);
	EXPECT_EQ(641, Pictures[1].Image.Width);
	EXPECT_TRUE(RunText("").Figures.empty());
}

TEST(ArticleEffectsRun, InsertedPassesBuildTheChainOfTheSettings)
{
	const FRunResult BySettings = RunText(R"("GlowIntensity": 0.5)");
	const FRunResult ByPasses = RunText("", R"(, "passes": [
		{"type": "REDDownSample", "at": "MotionBlur", "name": "Half", "replace": false},
		{"type": "REDBlurH", "at": "MotionBlur", "name": "H", "replace": false, "inputs": {"Input": "Half"}},
		{"type": "REDBlurV", "at": "MotionBlur", "name": "V", "replace": false, "inputs": {"Input": "H"}},
		{"type": "REDGlow", "at": "MotionBlur", "inputs": {"Blurred": "V"}, "parameters": {"Intensity": 0.5}}])");
	EXPECT_EQ(BySettings.Final.ToImage().Values, ByPasses.Final.ToImage().Values);
}

TEST(ArticleEffectsRun, CharaGlowPassByPassIsTheEffect)
{
	const FRunResult BySettings = RunText(R"("CharaGlowArea": 5.5, "CharaGlowColor": [1, 0.5, 0.25, 1])");
	const FRunResult ByPasses = RunText("", R"(, "passes": [
		{"type": "CharaGlow", "at": "MotionBlur", "name": "Wide", "replace": false, "parameters": {"Area": 5.5}},
		{"type": "CharaGlowComp", "at": "MotionBlur", "inputs": {"Widened": "Wide"}, "parameters": {"Color": [1, 0.5, 0.25, 1]}}])");
	EXPECT_EQ(BySettings.Final.ToImage().Values, ByPasses.Final.ToImage().Values);
}

TEST(ArticleEffectsRun, BlurOfOneEffectServesAnother)
{
	// The Unity lesson's blur under the RED glow: a combination that no article has.
	const FRunResult Result = RunText("", R"(, "passes": [
		{"type": "UnityBloomGaussianBlurVertical", "at": "MotionBlur", "name": "V", "replace": false, "parameters": {"Spread": 2}},
		{"type": "REDGlow", "at": "MotionBlur", "inputs": {"Blurred": "V"}, "parameters": {"Intensity": 0.5}}])");
	EXPECT_GT(FindPass(Result, "RED.Glow"), FindPass(Result, "UnityBloom.GaussianBlurVertical"));
	EXPECT_NE(RunText("").Final.ToImage().Values, Result.Final.ToImage().Values);
}
