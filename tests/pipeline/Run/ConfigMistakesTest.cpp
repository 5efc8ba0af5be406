// Everything that is wrong with a run is said at once: one mistake of each kind, alone, with each other one, and all
// together in configs of this test and in every_mistake.json.
#include <gtest/gtest.h>

#include "Run/Run.h"

#include <algorithm>
#include <map>

using namespace Drydock;

namespace
{

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

/** What a mistake has to do with the scene's file. */
enum class EScene
{
	Any,
	Missing, // it is that there is none
	Needed,  // only the file can tell
};

struct FMistake
{
	const char* Section; // of the config: "" is the root, "--pp" and the like the command line
	const char* Text;    // a member or element of it
	const char* Said;    // a part of the message
	EScene Scene = EScene::Any;
	bool bFile = false; // exit code 3 where nothing else is wrong
};

const FMistake GMistakes[] = {
	{"", R"("volums": [])", "unknown key \"volums\""},
	{"", R"("$schema": 5)", "expected a string, found a number"},
	{"", R"("engine": "4.9")", "\"4.9\" is not one of"},
	{"plugins", R"("libNone.so")", "libNone.so does not exist", EScene::Any, true},
	{"plugins", R"("scenes/two_boxes.exr")", "the plugin cannot be loaded"},
	{"scene", R"("file": "scenes/none.exr")", "none.exr: error DD5001", EScene::Missing, true},
	{"scene.channels", R"("dept.Z": "R")", "no pass knows a channel \"dept.Z\""},
	{"scene.channels", R"("depth.Z": "Deep.V")", "has no channel \"Deep.V\"", EScene::Needed},
	{"scene.channels", R"("velocity.X": 5)", "at /scene/channels/velocity.X: expected a string"},
	{"scene.defaults", R"("normal.W": 1)", "no pass knows a channel \"normal.W\""},
	{"scene.defaults", R"("A": "1")", "expected a number, found a string"},
	{"scene", R"("padding": -1)", "padding must be a whole number of texels"},
	{"scene", R"("screenPercentage": 0)", "screenPercentage must be above 0"},
	{"scene", R"("fps": 0)", "fps must be 0.01 to 10000"},
	{"scene", R"("frames": "1-8")", "frames need a sequence"},
	{"view", R"("fov": 200)", "fov must be an angle"},
	{"view", R"("exposure": 0)", "exposure must be above 0"},
	{"view", R"("rect": [0, 0, 9999, 10])", "the rect leaves the scene", EScene::Needed},
	{"view", R"("location": [1, 2])", "expected three numbers, found 2"},
	{"volumes", R"({"bUnbound": true, "Settings": {"BloomIntensty": 1}})", "did you mean BloomIntensity?"},
	{"volumes", R"({"bUnbound": true, "Settings": {"BloomIntensity": "high"}})", "BloomIntensity must be a number"},
	{"volumes", R"({"bUnbound": true, "Settings": {"BloomThreshold": NaN}})", "DD1004"},
	{"volumes", R"({"bUnbound": true, "Priority": 5, "Priority": 6})", "DD1003"},
	{"volumes", R"({"bUnbound": true, "Settings": {"BloomDirtMask": "textures/none.png"}})",
		"BloomDirtMask " DRYDOCK_TEST_SOURCE_DIR "/configs/textures/none.png", EScene::Any, true},
	{"volumes", R"({"Settings": {}})", "has no \"bounds\" and is not bUnbound"},
	{"volumes", R"({"bounds": {"min": [0, 0, 0], "max": [1, -1, 1]}})", "min must not be above max in Y"},
	{"volumes", R"({"bUnbound": true, "Weight": 1})", "unknown key \"Weight\""},
	{"volumes", R"({"bUnbound": true, "BloomThreshold": 1})",
		"unknown key \"BloomThreshold\"; this is a setting, and belongs in \"Settings\" beside it"},
	{"volumes", R"({"bUnbound": true, "BloomThreshhold": 1})", "did you mean BloomThreshold? That is a setting, and"},
	{"", R"("AutoExposureBias": 1)", "belongs in the \"Settings\" of \"camera\" or of a volume"},
	{"", R"("r.BloomQuality": 1)", "belongs in \"cvars\" of the config"},
	{"camera.Settings", R"("bOverride_Bloom": true)", "at /camera/Settings/bOverride_Bloom: unknown setting"},
	{"camera.Settings", R"("ScreenPercentage": 50)",
		"unknown setting; engine 5 has no setting of this name: set scene.screenPercentage of the config"},
	{"cvars", R"("r.BloomQualty": 1)", "did you mean r.BloomQuality?"},
	{"cvars", R"("r.BloomQuality": [1])", "at /cvars/r.BloomQuality: expected a number"},
	{"showFlags", R"("Blom": false)", "unknown show flag; did you mean Bloom?"},
	{"showFlags", R"("Grain": 0)", "expected true or false, found a number"},
	{"extensions", R"({"type": "Tind"})", "there is no extension \"Tind\""},
	{"extensions", R"({"pass": "MotionBlur"})", "\"type\" is missing: Name of the extension."},
	{"extensions", R"({"type": "Tint", "Colour": 1})", "Tint has no parameter \"Colour\""},
	{"extensions", R"({"type": "Tint", "pass": "Tonemaper"})", "did you mean Tonemap?"},
	{"extensions", R"({"type": "Tint", "Left": 2})", "Left must be in 0 .. 1"},
	{"passes", R"({"type": "Tindt", "at": "Tonemap"})", "there is no pass \"Tindt\""},
	{"passes", R"({"type": "Tint"})", "\"at\" is missing"},
	{"passes", R"({"type": "Tint", "at": "MotionBlurr"})", "did you mean MotionBlur?"},
	{"passes", R"({"type": "Tint", "at": "FXAA", "inputs": {"Imput": "SceneColor"}})", "no input \"Imput\""},
	{"passes", R"({"type": "Tint", "at": "FXAA", "inputs": {"Input": "SceneColour"}})", "no resource \"SceneColour\""},
	{"passes", R"({"type": "CharaGlowComp", "at": "FXAA", "inputs": {"Widened": 5}})", "expected a string"},
	{"passes", R"({"type": "Tint", "at": "FXAA", "parameters": {"Shade": 1}})", "no parameter \"Shade\""},
	{"passes", R"({"type": "Tint", "at": "FXAA", "replace": 1})", "at /passes/"},
	{"outputs", R"("dump": [5])", "at /outputs/dump/0: expected a string"},
	{"study.axes", R"({"name": "r.BloomQualties", "values": [1]})", "did you mean r.BloomQuality?"},
	{"study.axes", R"({"name": "BloomIntensity", "values": []})", "\"values\" must be an array of at least one value"},
	{"study.axes", R"({"name": "BloomIntensity", "values": ["much"]})", "expected a number, found \"much\""},
	{"study", R"("metrics": [1])", "at /study/metrics/0: expected a string"},
	{"study", R"("repetitions": 0)", "repetitions must be a whole number"},
	{"study", R"("region": [1, 2, 3, "4"])", "at /study/region/3: expected a number"},
	{"study", R"("reference": "best")", "the reference of a study of frames"},
	{"budget", R"("metric": "rmss")", "there is no metric \"rmss\""},
	{"budget", R"("max": 0)", "\"max\" must be above 0"},
	{"--pp", "BloomIntensty=1", "command line: error DD1012"},
	{"--pp", "BloomIntensity", "\"BloomIntensity\" is not NAME=VALUE"},
	{"--set", "r.BloomQalty=1", "r.BloomQalty"},
	{"--exec", "r.BloomQlty 1", "r.BloomQlty"},
};

using FMistakes = std::vector<const FMistake*>;

bool IsArray(const std::string& Section)
{
	return Section == "plugins" || Section == "volumes" || Section == "extensions" || Section == "passes" ||
		   Section == "study.axes";
}

/** A config that is right but for these. */
FRunOptions MakeRun(const FMistakes& Mistakes)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/mistakes.json";
	std::map<std::string, std::string> Sections;
	const auto Add = [&](const std::string& Section, const std::string& Text)
	{
		Sections[Section] += (Sections[Section].empty() ? "" : ", ") + Text;
	};
	bool bScene = true;
	for (const FMistake* Mistake : Mistakes)
	{
		bScene = bScene && Mistake->Scene != EScene::Missing;
		const std::string Section = Mistake->Section;
		std::vector<std::string>* const Arguments = Section == "--pp"    ? &Options.Settings
													: Section == "--set" ? &Options.Variables
																		 : nullptr;
		if (Arguments != nullptr)
		{
			Arguments->push_back(Mistake->Text);
		}
		else if (Section == "--exec")
		{
			Options.Exec.push_back({Mistake->Text, 0});
		}
		else
		{
			Add(Section, Mistake->Text);
		}
	}
	if (bScene)
	{
		Add("scene", R"("file": "scenes/two_boxes.exr")");
	}
	if (Sections.count("study") != 0 || Sections.count("study.axes") != 0)
	{
		Add("study.axes", R"({"name": "r.BloomQuality", "values": [1, 5]})");
	}
	if (Sections.count("budget") != 0)
	{
		Add("budget", R"("ms": 5)");
	}
	for (const char* Inner : {"scene.channels", "scene.defaults", "camera.Settings", "study.axes"})
	{
		if (Sections.count(Inner) != 0)
		{
			const std::string Name = Inner;
			const size_t Dot = Name.find('.');
			const char* const Brackets = IsArray(Name) ? "[]" : "{}";
			Add(Name.substr(0, Dot),
				"\"" + Name.substr(Dot + 1) + "\": " + Brackets[0] + Sections[Inner] + Brackets[1]);
			Sections.erase(Inner);
		}
	}
	std::string Text;
	for (const auto& [Section, Members] : Sections)
	{
		const char* const Brackets = IsArray(Section) ? "[]" : "{}";
		Text += (Text.empty() ? "" : ",\n") +
				(Section.empty() ? Members : "\"" + Section + "\": " + Brackets[0] + Members + Brackets[1]);
	}
	Options.ConfigText = "{" + Text + "}";
	return Options;
}

struct FSaid
{
	std::vector<std::string> Errors;
	int ExitCode = 0;
};

FSaid Check(const FRunOptions& Options)
{
	try
	{
		CheckConfig(Options);
		return {};
	}
	catch (const FError& Error)
	{
		FSaid Said{{}, Error.GetExitCode()};
		for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			if (Diagnostic.Severity == ESeverity::Error)
			{
				Said.Errors.push_back(Diagnostic.ToString());
			}
		}
		return Said;
	}
}

/** One message for each mistake and no other, and the exit code. */
void ExpectAllSaid(const FMistakes& Mistakes)
{
	const FRunOptions Options = MakeRun(Mistakes);
	const FSaid Said = Check(Options);
	std::string All;
	for (const std::string& Error : Said.Errors)
	{
		All += Error + "\n";
	}
	for (const FMistake* Mistake : Mistakes)
	{
		EXPECT_NE(std::string::npos, All.find(Mistake->Said)) << Mistake->Said << " is not in\n" << All;
	}
	EXPECT_EQ(Mistakes.size(), Said.Errors.size()) << *Options.ConfigText << "\n" << All;
	const bool bFilesOnly =
		std::all_of(Mistakes.begin(), Mistakes.end(), [](const FMistake* Mistake) { return Mistake->bFile; });
	EXPECT_EQ(bFilesOnly ? ExitFiles : ExitUsage, Said.ExitCode) << All;
}

} // namespace

TEST(MistakesTogether, NoneIsSaidOfAConfigWithoutOne)
{
	EXPECT_TRUE(Check(MakeRun({})).Errors.empty());
}

TEST(MistakesTogether, EachAloneIsOneMessage)
{
	for (const FMistake& Mistake : GMistakes)
	{
		ExpectAllSaid({&Mistake});
	}
}

TEST(MistakesTogether, NoneHidesAnother)
{
	for (const FMistake& First : GMistakes)
	{
		for (const FMistake* Second = &First + 1; Second != std::end(GMistakes); ++Second)
		{
			const bool bUnknowable = (First.Scene == EScene::Missing && Second->Scene == EScene::Needed) ||
									 (First.Scene == EScene::Needed && Second->Scene == EScene::Missing);
			if (!bUnknowable)
			{
				ExpectAllSaid({&First, Second});
			}
		}
		if (testing::Test::HasFailure())
		{
			return; // one is enough to look at
		}
	}
}

TEST(MistakesTogether, AllAreSaidTogether)
{
	for (const EScene Other : {EScene::Missing, EScene::Needed})
	{
		FMistakes Mistakes;
		for (const FMistake& Mistake : GMistakes)
		{
			if (Mistake.Scene == EScene::Any || Mistake.Scene == Other)
			{
				Mistakes.push_back(&Mistake);
			}
		}
		ExpectAllSaid(Mistakes);
	}
}

TEST(MistakesTogether, BrokenJsonStandsAlone)
{
	FRunOptions Options = MakeRun({&GMistakes[3]});
	Options.Settings = {"BloomIntensty=1"};
	Options.ConfigText->back() = ']';
	const FSaid Said = Check(Options);
	ASSERT_EQ(1u, Said.Errors.size());
	EXPECT_NE(std::string::npos, Said.Errors[0].find("DD1001")) << Said.Errors[0];
	EXPECT_EQ(ExitUsage, Said.ExitCode);
}

TEST(MistakesTogether, UnknownNamesMayBeThoseOfAPluginThatIsMissing)
{
	FRunOptions Options = MakeRun({});
	Options.ConfigText = R"({"plugins": ["libNone.so"], "cvars": {"r.OfNone": 1}})";
	const FSaid Said = Check(Options);
	ASSERT_EQ(2u, Said.Errors.size());
	EXPECT_TRUE(Said.Errors[1].ends_with(" (or a plugin that could not be loaded has it)")) << Said.Errors[1];
}

TEST(MistakesTogether, ARunSaysThemAsACheckDoesAndThatThereIsNoScene)
{
	FRunOptions Options;
	Options.ConfigFile = "a.json";
	Options.ConfigText = R"({"showFlags": {"Blom": true}})";
	try
	{
		RunConfig(Options);
		FAIL();
	}
	catch (const FError& Error)
	{
		ASSERT_EQ(2u, Error.GetDiagnostics().size());
		EXPECT_EQ("/showFlags/Blom", Error.GetDiagnostics()[0].Where);
		EXPECT_EQ("/scene/file", Error.GetDiagnostics()[1].Where);
	}
	EXPECT_EQ(1u, Check(Options).Errors.size());
}

TEST(MistakesTogether, TheConfigWithOneOfEveryKindNamesThemInOrder)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "tests/pipeline/Run/every_mistake.json";
	for (const bool bRun : {false, true})
	{
		try
		{
			bRun ? static_cast<void>(RunConfig(Options)) : static_cast<void>(CheckConfig(Options));
			FAIL();
		}
		catch (const FError& Error)
		{
			std::string Text;
			for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
			{
				Text += std::to_string(Diagnostic.Code) + " " + std::to_string(Diagnostic.Line) + " " +
						Diagnostic.Where + "\n";
			}
			EXPECT_EQ("1007 2 /engine\n"
					  "5001 3 /plugins/0\n"
					  "1005 6 /scene/channel\n"
					  "1010 7 /scene/padding\n"
					  "1010 9 /view/fov\n"
					  "1019 11 /volumes/0\n"
					  "1012 12 /volumes/1/Settings/BloomIntensty\n"
					  "5001 13 /volumes/2/Settings/BloomDirtMask\n"
					  "1013 15 /cvars/r.BloomQualty\n"
					  "1014 16 /showFlags/Blom\n"
					  "2080 18 /extensions/0/type\n"
					  "1005 19 /extensions/1/Colour\n"
					  "2081 22 /passes/0/type\n"
					  "2082 23 /passes/1/inputs/Imput\n"
					  "1007 25 /study/axes/0/name\n"
					  "1007 26 /budget/metric\n"
					  "5001 0 \n",
				Text);
			EXPECT_EQ(ExitUsage, Error.GetExitCode());
		}
	}
}
