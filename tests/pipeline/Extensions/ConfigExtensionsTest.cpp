// Extensions, inserted passes, plugins and views as a config gives them: mistakes with their place, and what they do to
// the frame.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Extensions/ConfigExtensions.h"
#include "Extensions/ExtensionErrors.h"
#include "Program/ExtensionList.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace
{

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

FConfig Read(const std::string& Text, std::vector<FDiagnostic>& Diagnostics)
{
	return ReadConfig(Text, "a.json", Diagnostics);
}

/** "code line:column pointer: message" of the only mistake. */
std::string OnlyMistake(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = Read(Text, Diagnostics);
	ReadExtensionRequests(Config, Diagnostics);
	ReadPassRequests(Config, Diagnostics);
	if (Diagnostics.size() != 1)
	{
		return std::to_string(Diagnostics.size()) + " mistakes";
	}
	const FDiagnostic& Only = Diagnostics[0];
	return std::to_string(Only.Code) + " " + std::to_string(Only.Line) + ":" + std::to_string(Only.Column) + " " +
		   Only.Where + ": " + Only.Message;
}

std::string Extension(const std::string& Members)
{
	return R"({"extensions": [{)" + Members + "}]}";
}

std::string Pass(const std::string& Members)
{
	return R"({"passes": [{)" + Members + "}]}";
}

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

FRunResult RunWith(const std::string& More)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr"},
		"camera": {"Settings": {"BloomIntensity": 0, "VignetteIntensity": 0}}, )" +
						 More + "}";
	return RunConfig(Options);
}

std::string ErrorOf(const std::string& More)
{
	try
	{
		RunWith(More);
	}
	catch (const FError& Error)
	{
		return std::to_string(Error.GetDiagnostics().back().Code) + " " + std::to_string(Error.GetExitCode());
	}
	return "none";
}

} // namespace

// Mistakes
// ----------------------------------------------------------------------------------------------------------------

TEST(ConfigExtensions, UnknownTypeNamesTheNearest)
{
	const std::string Mistake = OnlyMistake(Extension(R"("type": "Tind")"));
	EXPECT_EQ(0u, Mistake.find("2080 1:26 /extensions/0/type: there is no extension \"Tind\"; did you mean Tint?"))
		<< Mistake;
}

TEST(ConfigExtensions, UnknownParameterNamesTheNearest)
{
	EXPECT_EQ("1005 1:34 /extensions/0/Colour: Tint has no parameter \"Colour\"; did you mean Color?",
		OnlyMistake(Extension(R"("type": "Tint", "Colour": [1, 1, 1])")));
}

TEST(ConfigExtensions, WrongTypesAndRanges)
{
	EXPECT_EQ("1010 1:42 /extensions/0/Left: Left must be in 0 .. 1",
		OnlyMistake(Extension(R"("type": "Tint", "Left": 1.5)")));
	EXPECT_TRUE(Contains(OnlyMistake(Extension(R"("type": "Tint", "Left": "0")")), "1006 "));
	EXPECT_TRUE(Contains(OnlyMistake(Extension(R"("type": "Tint", "Color": [1, 2])")), "expected a colour"));
	EXPECT_TRUE(
		Contains(OnlyMistake(Extension(R"("type": "DualKawaseBlur", "PassNum": 2.5)")), "expected a whole number"));
}

TEST(ConfigExtensions, UnknownHook)
{
	EXPECT_TRUE(Contains(OnlyMistake(Extension(R"("type": "Tint", "pass": "Tonemapp")")), "did you mean Tonemap?"));
	EXPECT_TRUE(Contains(OnlyMistake(Extension(R"("type": "Tint", "pass": "BeforeDOF")")),
		"engine 5.4 has no hook BeforeDOF: it is there from 5.5"));
	EXPECT_EQ("0 mistakes", OnlyMistake(R"({"engine": "5.5", "extensions": [{"type": "Tint", "pass": "BeforeDOF"}]})"));
}

TEST(ConfigPasses, UnknownTypeInputAndResource)
{
	EXPECT_TRUE(Contains(OnlyMistake(Pass(R"("type": "Gaussian", "at": "MotionBlur")")), "2081 "));
	EXPECT_EQ("0 mistakes", OnlyMistake(Pass(R"("type": "TINT", "at": "MotionBlur")"))); // as Unity writes names
	EXPECT_TRUE(Contains(OnlyMistake(Pass(R"("type": "Tint", "at": "MotionBlur", "inputs": {"Imput": "SceneColor"})")),
		"did you mean Input?"));
	EXPECT_TRUE(Contains(OnlyMistake(Pass(R"("type": "Tint", "at": "MotionBlur", "inputs": {"Input": "SceneColour"})")),
		"did you mean SceneColor?"));
	EXPECT_TRUE(Contains(OnlyMistake(Pass(R"("type": "Tint", "at": "Bloom")")), "is not a hook of Tint"));
	EXPECT_TRUE(Contains(
		OnlyMistake(Pass(R"("type": "Tint", "at": "Tonemap", "parameters": {"Colr": 1})")), "did you mean Color?"));
}

TEST(ConfigPasses, MayReadEarlierOnesOnly)
{
	EXPECT_EQ("0 mistakes", OnlyMistake(R"({"passes": [
		{"type": "Downsample", "at": "MotionBlur", "name": "Small"},
		{"type": "Tint", "at": "MotionBlur", "inputs": {"Input": "Small"}}]})"));
	EXPECT_TRUE(Contains(OnlyMistake(R"({"passes": [
		{"type": "Tint", "at": "MotionBlur", "inputs": {"Input": "Small"}},
		{"type": "Downsample", "at": "MotionBlur", "name": "Small"}]})"),
		"there is no resource \"Small\""));
}

TEST(ConfigViews, EachOfSeveralHasItsRect)
{
	std::vector<FDiagnostic> Diagnostics;
	Read(R"({"views": [{"rect": [0, 0, 4, 4]}, {}]})", Diagnostics);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ("/views/1", Diagnostics[0].Where);
}

TEST(ConfigViews, StandInPlaceOfView)
{
	std::vector<FDiagnostic> Diagnostics;
	Read(R"({"view": {}, "views": [{}]})", Diagnostics);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(ErrorBadValue, Diagnostics[0].Code);
}

TEST(ConfigEngine, EveryRowOfTheProfileCanBeChosen)
{
	std::vector<FDiagnostic> Diagnostics;
	for (const FEngineProfile& Engine : GetEngineProfiles())
	{
		const FConfig Config = Read(R"({"engine": ")" + Engine.GetVersion() + R"("})", Diagnostics);
		EXPECT_EQ(Engine.Minor, Config.GetEngineProfile().Minor);
	}
	EXPECT_TRUE(Diagnostics.empty());
	Read(R"({"engine": "5.9"})", Diagnostics);
	EXPECT_EQ(1u, Diagnostics.size());
}

// What they do
// ------------------------------------------------------------------------------------------------------------

TEST(RunExtensions, TintTintsItsAreaAtItsHook)
{
	const FRunResult Plain = RunWith(R"("cvars": {})");
	const FRunResult Tinted =
		RunWith(R"("extensions": [{"type": "Tint", "pass": "MotionBlur", "Color": [2, 1, 0], "Right": 0.5}])");
	// 641 wide: the centre of pixel 319 is left of the middle, that of 321 right of it.
	EXPECT_EQ(2.0 * Plain.SceneLinear.Get(319, 100, 0), Tinted.SceneLinear.Get(319, 100, 0));
	EXPECT_EQ(Plain.SceneLinear.Get(319, 100, 1), Tinted.SceneLinear.Get(319, 100, 1));
	EXPECT_EQ(0.0, Tinted.SceneLinear.Get(319, 100, 2));
	EXPECT_EQ(Plain.SceneLinear.Get(321, 100, 0), Tinted.SceneLinear.Get(321, 100, 0));
}

TEST(RunExtensions, TintInPlaceIsTheSameAsAfterMotionBlur)
{
	const FRunResult Before =
		RunWith(R"("extensions": [{"type": "Tint", "pass": "PrePostProcessPass", "Color": [2, 1, 0]}])");
	const FRunResult After = RunWith(R"("extensions": [{"type": "Tint", "pass": "MotionBlur", "Color": [2, 1, 0]}])");
	EXPECT_EQ(After.SceneLinear.ToImage().Values, Before.SceneLinear.ToImage().Values);
	EXPECT_EQ(After.Final.ToImage().Values, Before.Final.ToImage().Values);
}

TEST(RunExtensions, TintAfterTheTonemapperIsTheOutput)
{
	const FRunResult Result = RunWith(R"("extensions": [{"type": "Tint", "pass": "Tonemap", "Color": [0, 0, 0]}])");
	EXPECT_EQ(0.0, Result.Final.Get(300, 100, 1));
	EXPECT_NE(0.0, Result.SceneLinear.Get(300, 100, 1));
}

TEST(RunExtensions, AreGoneWithTheirRun)
{
	RunWith(R"("extensions": [{"type": "Tint"}])");
	EXPECT_TRUE(RunWith(R"("cvars": {})").HookCalls.empty());
}

TEST(RunExtensions, FollowTheConfigsEngine)
{
	const FRunResult Result = RunWith(R"("engine": "5.6", "extensions": [{"type": "Tint", "pass": "AfterDOF"}])");
	EXPECT_TRUE(Result.Diagnostics.empty());
	EXPECT_EQ(1u + 9u, Result.HookPoints.size()); // PrePostProcessPass and those of 5.5
}

TEST(RunExtensions, MistakesEndTheRunBeforeItStarts)
{
	EXPECT_EQ("2080 2", ErrorOf(R"("extensions": [{"type": "Nothing"}])"));
	EXPECT_EQ("5001 3", ErrorOf(R"("plugins": ["libNothing.so"])"));
	EXPECT_EQ("2083 2", ErrorOf(R"("plugins": ["scenes/two_boxes.exr"])"));
	EXPECT_EQ(
		"2082 2", ErrorOf(R"("passes": [{"type": "Tint", "at": "MotionBlur", "inputs": {"Input": "CustomDepth"}}])"));
}

TEST(RunPasses, InsertedPassIsTheExtensionsPass)
{
	const FRunResult Extension = RunWith(R"("extensions": [{"type": "Tint", "pass": "Tonemap", "Color": [0, 1, 0]}])");
	const FRunResult Inserted =
		RunWith(R"("passes": [{"type": "Tint", "at": "Tonemap", "parameters": {"Color": [0, 1, 0]}}])");
	EXPECT_EQ(Extension.Final.ToImage().Values, Inserted.Final.ToImage().Values);
	const FRunResult Before =
		RunWith(R"("passes": [{"type": "Tint", "at": "PrePostProcessPass", "parameters": {"Color": [0, 1, 0]}}])");
	EXPECT_EQ(0.0, Before.SceneLinear.Get(300, 100, 0));
	EXPECT_EQ(Extension.SceneLinear.Get(300, 100, 1), Before.SceneLinear.Get(300, 100, 1));
}

TEST(RunPasses, SmallerPictureIsStretchedByTheTonemapper)
{
	const FRunResult Result = RunWith(R"("passes": [{"type": "Downsample", "at": "MotionBlur"}])");
	EXPECT_EQ(321, Result.SceneLinear.Width);
	EXPECT_EQ(641, Result.Final.Width);
}

TEST(RunPasses, OneThatReplacesNothingIsThereByName)
{
	const FRunResult Result = RunWith(R"("passes": [
		{"type": "Tint", "at": "MotionBlur", "name": "Black", "replace": false, "parameters": {"Color": [0, 0, 0]}},
		{"type": "Downsample", "at": "Tonemap", "inputs": {"Input": "Black"}}])");
	EXPECT_NE(0.0, Result.SceneLinear.Get(300, 100, 1));
	EXPECT_EQ(0.0, Result.Final.Get(300, 100, 1)); // half size, drawn to the whole output
}

TEST(RunPasses, UnreadResultIsCulled)
{
	const FRunResult Result = RunWith(R"("passes": [{"type": "Tint", "at": "MotionBlur", "replace": false}])");
	const auto& Passes = Result.Graph.Passes;
	const auto Tint = std::find_if(Passes.begin(), Passes.end(),
		[](const FRDGCompiledPass& Compiled) { return Compiled.Name.starts_with("Tint "); });
	ASSERT_NE(Passes.end(), Tint);
	EXPECT_TRUE(Tint->bCulled);
}

TEST(RunViews, EachHasItsOwnSettings)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/two_views.json";
	const FRunResult Result = RunConfig(Options);
	ASSERT_EQ(2u, Result.Views.size());
	EXPECT_EQ(1.0f, Result.Views[0].ExposureScale);
	EXPECT_EQ(1.5f, Result.Views[1].ExposureScale);
	EXPECT_TRUE(Contains(Result.Views[0].Effects[0].Reason, "0.675")) << Result.Views[0].Effects[0].Reason;
	EXPECT_TRUE(Contains(Result.Views[1].Effects[0].Reason, "is 3")) << Result.Views[1].Effects[0].Reason;
	EXPECT_EQ(960, Result.Final.Width);
	EXPECT_EQ(540, Result.SceneLinear.Height);
}

TEST(RunViews, LeftOneIsWhatItWouldBeAlone)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/two_views.json";
	const FRunResult Both = RunConfig(Options);
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character.exr"},
		"view": {"rect": [0, 0, 480, 540], "location": [-1000, 0, 100]},
		"extensions": [{"type": "Tint", "pass": "MotionBlur", "Color": [0.8, 0.9, 1], "Bottom": 0.25}]})";
	const FRunResult Alone = RunConfig(Options);
	for (int Y = 0; Y < 540; ++Y)
	{
		for (int X = 0; X < 480; ++X)
		{
			ASSERT_EQ(Alone.Final.Get(X, Y, 0), Both.Final.Get(X, Y, 0)) << X << ", " << Y;
		}
	}
}

TEST(RunViews, ReportListsThem)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/two_views.json";
	Options.bExecute = false;
	const std::string Report = RunConfig(Options).RunJson;
	EXPECT_TRUE(Contains(Report, "\"name\": \"View 1\""));
	EXPECT_TRUE(Contains(Report, "\"extensionCalls\""));
}

TEST(ExtensionLists, HaveTypesParametersAndHooks)
{
	const auto HasRow = [](const FListTable& Table, const std::vector<std::string>& Begin)
	{
		return std::any_of(Table.Rows.begin(), Table.Rows.end(),
			[&](const std::vector<std::string>& Row) { return std::equal(Begin.begin(), Begin.end(), Row.begin()); });
	};
	EXPECT_TRUE(HasRow(ListExtensions(), {"Tint", "parameter", "Left", "number", "0", "0 .. 1"}));
	EXPECT_TRUE(HasRow(ListExtensions(), {"GaussianBlur", "input", "Input", "resource", "SceneColor"}));
	EXPECT_TRUE(HasRow(ListHooks(), {"Tonemap", "5.1", "display-encoded"}));
	EXPECT_TRUE(HasRow(ListHooks(), {"PreRenderBasePass", "5.4", "hook"}));
	EXPECT_TRUE(HasRow(ListHooks(), {"PrePostProcessPassMobile", "never", "hook",
										"PrePostProcessPassMobile_RenderThread(FRDGBuilder&, const FSceneView&, const "
										"FMobilePostProcessingInputs&): it is the mobile renderer's: the deferred one "
										"never calls it; override PrePostProcessPass_RenderThread(FRDGBuilder&, "
										"const FSceneView&, const FPostProcessingInputs&)"}));
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/hooks_all.json";
	const FListTable Chain = ListHooks(Options);
	EXPECT_TRUE(HasRow(Chain,
		{"PrePostProcessPass", "linear HDR, pre-exposed", "SceneColor", "PF_FloatRGBA", "960x540", "Tint", "yes"}));
	EXPECT_TRUE(HasRow(Chain, {"Tonemap", "display-encoded", "Tonemap", "PF_B8G8R8A8", "960x540"}));
}
