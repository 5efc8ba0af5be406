// Toon bloom in whole frames: when it runs, what it reads, what it reports.
#include <gtest/gtest.h>

#include "pipeline/EffectTestUtils.h"
#include "Picture/ImageFile.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"
#include "Text/Json.h"

#include <algorithm>
#include <filesystem>

using namespace Drydock;

namespace
{

const std::string ConfigFolder = DRYDOCK_TEST_SOURCE_DIR "/configs/";

FRunResult RunToon(const std::string& Settings, const std::vector<std::string>& Variables = {},
	const std::string& Scene = R"("file": "scenes/toon_character.exr")")
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFolder + "text.json";
	Options.ConfigText =
		R"({"scene": {)" + Scene + R"(}, "volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]}";
	Options.Variables = Variables;
	Options.bMeasureEffects = true;
	return RunConfig(Options);
}

double GetBleed(const FRunResult& Result, const char* Side)
{
	return FindFigures(Result, EEffect::ToonBloom).Get("bleed", Side);
}

bool HasPass(const FRunResult& Result, const std::string& Begin)
{
	return std::any_of(Result.Graph.Passes.begin(), Result.Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return !Pass.bCulled && Pass.Name.starts_with(Begin); });
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
	std::sort(Names.begin(), Names.end());
	return Names;
}

} // namespace

TEST(ToonBloomRun, BringsTheSetupPassAndReadsTheIdsOnly)
{
	const FRunResult Result = RunToon(R"("BloomToonIntensity": 0.1)");
	EXPECT_TRUE(HasPass(Result, "BloomSetup"));
	EXPECT_TRUE(HasPass(Result, "ToonBloomMask"));
	EXPECT_EQ((std::vector<std::string>{"A", "B", "G", "R", "shadingmodel.ID"}), GetDecoded(Result));
	const std::string Reason = FindEffect(Result, "ToonBloom").Reason;
	EXPECT_TRUE(Reason.starts_with("BloomToonIntensity is 0.1: it brings the setup pass into the graph; toon in "))
		<< Reason;
}

TEST(ToonBloomRun, FactorOneGivesTheBitsOfAFrameWithoutIt)
{
	const FRunResult Without = RunToon("");
	const FRunResult Neutral = RunToon(R"("BloomToonIntensity": 1)");
	const FRunResult Forced = RunToon(R"("BloomToonIntensity": 1)", {"r.ToonBloom=1"});
	EXPECT_FALSE(HasPass(Without, "BloomSetup"));
	EXPECT_FALSE(HasPass(Neutral, "BloomSetup"));
	EXPECT_TRUE(HasPass(Forced, "BloomSetup"));
	EXPECT_EQ(Without.Final.ToImage().Values, Neutral.Final.ToImage().Values);
	EXPECT_EQ(Without.Final.ToImage().Values, Forced.Final.ToImage().Values);
}

TEST(ToonBloomRun, FactorOneWithAThresholdToo)
{
	EXPECT_EQ(RunToon(R"("BloomThreshold": 0.5)").Final.ToImage().Values,
		RunToon(R"("BloomThreshold": 0.5, "BloomToonIntensity": 1)", {"r.ToonBloom=1"}).Final.ToImage().Values);
}

TEST(ToonBloomRun, SwitchedOffGivesTheBitsOfAFrameWithoutIt)
{
	EXPECT_EQ(RunToon("").Final.ToImage().Values,
		RunToon(R"("BloomToonIntensity": 0.1)", {"r.ToonBloom=0"}).Final.ToImage().Values);
}

TEST(ToonBloomRun, BeginsAtZeroWhereTheDefaultFeatureIsOff)
{
	const FRunResult Off = RunToon(R"("BloomIntensity": 1.5)", {"r.DefaultFeature.Bloom=0"});
	EXPECT_EQ(RunToon(R"("BloomIntensity": 1.5, "BloomToonIntensity": 0)").Final.ToImage().Values,
		Off.Final.ToImage().Values);
	EXPECT_NE(RunToon(R"("BloomIntensity": 1.5)").Final.ToImage().Values, Off.Final.ToImage().Values);
}

TEST(ToonBloomRun, WithoutAThresholdTheSetupOf53KeepsItsRamp)
{
	// A grey frame without toon, and a factor of 1: all that the setup pass does is its ramp, (L + 1) / 2 of the engine
	// up to 5.3 at a threshold of -1, and bloom is linear in what it gives.
	const std::filesystem::path Folder = std::filesystem::temp_directory_path() / "drydock_toon_bloom_ramp";
	std::filesystem::create_directories(Folder);
	const auto Render = [&](double Grey, const std::string& Engine, const std::string& Mode)
	{
		WriteExr((Folder / "grey.exr").string(), {64, 32, 3, std::vector<double>(64 * 32 * 3, Grey)}, {"R", "G", "B"});
		FRunOptions Options;
		Options.ConfigFile = (Folder / "a.json").string();
		Options.ConfigText = R"({"engine": ")" + Engine + R"(", "scene": {"file": "grey.exr",
			"defaults": {"shadingmodel.ID": 1}}, "camera": {"Settings": {"BloomToonIntensity": 1}}})";
		Options.Variables = {"r.ToonBloom=" + Mode};
		Options.Storage = ERunStorage::Float32;
		Options.bMeasureEffects = true;
		return RunConfig(Options);
	};
	for (const double Grey : {0.06, 0.25, 0.96})
	{
		const FRunResult With = Render(Grey, "5.4", "1");
		EXPECT_NEAR((Grey + 1) / 2, GetBleed(Render(Grey, "5.3", "1"), "outside") / GetBleed(With, "outside"), 1e-4);
		const FImage Without = Render(Grey, "5.4", "0").Final.ToImage();
		EXPECT_EQ(Without.Values, With.Final.ToImage().Values);
		EXPECT_EQ(Without.Values, Render(Grey, "5.3", "0").Final.ToImage().Values); // no setup pass, no ramp
	}
	std::filesystem::remove_all(Folder);
}

TEST(ToonBloomRun, LessToonBleedsLess)
{
	const FRunResult Weak = RunToon(R"("BloomToonIntensity": 0.1)");
	const FRunResult Full = RunToon(R"("BloomToonIntensity": 1)", {"r.ToonBloom=1"});
	EXPECT_LT(GetBleed(Weak, "outside"), GetBleed(Full, "outside"));
	EXPECT_LT(GetBleed(Weak, "inside"), GetBleed(Full, "inside"));
	EXPECT_GT(GetBleed(Weak, "inside"), 0.0);
}

TEST(ToonBloomRun, TheReportHoldsTheBleed)
{
	const FRunResult Result = RunToon(R"("BloomToonIntensity": 0.1)");
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Report = ParseJson(Result.RunJson, "run.json", Ignored, bSyntaxError);
	const FJsonValue& Toon = Report.Find("effects")->Elements.at(2);
	EXPECT_EQ("ToonBloom", Toon.Find("name")->String);
	const FJsonValue* Bleed = Toon.Find("bleed");
	ASSERT_NE(nullptr, Bleed);
	EXPECT_DOUBLE_EQ(Bleed->Find("outside")->Number / Bleed->Find("inside")->Number, Bleed->Find("ratio")->Number);
	EXPECT_EQ(nullptr, Report.Find("effects")->Elements.at(0).Find("bleed"));
}

TEST(ToonBloomRun, TheMaskIsShownInPlaceOfBloom)
{
	const FRunResult Result = RunToon(R"("BloomToonIntensity": 0.1)", {"r.ToonBloom.VisualizeMask=1"});
	EXPECT_TRUE(HasPass(Result, "ToonBloomVisualizeMask"));
	EXPECT_FALSE(HasPass(Result, "BloomSetup"));
	EXPECT_FALSE(FindEffect(Result, "ToonBloom").bActive);
	EXPECT_EQ("r.ToonBloom.VisualizeMask shows the mask in its place", FindEffect(Result, "Bloom").Reason);
}

TEST(ToonBloomRun, AMissingIdIsOneErrorThatSaysWhatToDo)
{
	try
	{
		RunToon(R"("BloomToonIntensity": 0.1)", {}, R"("file": "../docs/images/toon_input.png")");
		FAIL() << "no error";
	}
	catch (const FError& Error)
	{
		ASSERT_EQ(1u, Error.GetDiagnostics().size());
		const FDiagnostic& Diagnostic = Error.GetDiagnostics()[0];
		EXPECT_EQ(ErrorChannelMissing, Diagnostic.Code);
		for (const char* Part :
			{"\"shadingmodel.ID\"", "ToonBloomMask", "GBufferB", "scene.channels", "scene.defaults"})
		{
			EXPECT_NE(std::string::npos, Diagnostic.Message.find(Part)) << Diagnostic.Message;
		}
	}
}

TEST(ToonBloomRun, ADefaultStandsInForTheMissingId)
{
	const std::string Picture = R"("file": "../docs/images/toon_input.png", "defaults": {"shadingmodel.ID": )";
	const FRunResult NoToon = RunToon(R"("BloomToonIntensity": 0)", {}, Picture + "1}");
	const FRunResult AllToon = RunToon(R"("BloomToonIntensity": 0)", {}, Picture + "8}");
	EXPECT_TRUE(FindEffect(NoToon, "ToonBloom").bNothingToDo);
	EXPECT_EQ(0.0, GetBleed(AllToon, "inside")); // none blooms, so nothing bleeds
	EXPECT_EQ(0.0, GetBleed(AllToon, "outside"));
}

TEST(ToonBloomRun, APlainPictureNeedsNoIdsWithoutIt)
{
	EXPECT_FALSE(RunToon("", {}, R"("file": "../docs/images/toon_input.png")").Final.ToImage().Values.empty());
}
