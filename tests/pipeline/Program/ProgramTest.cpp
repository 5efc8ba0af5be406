// The program as a user meets it: exit codes, what goes to stdout and stderr, nothing written after a mistake.
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

const std::string Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";
const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

struct FOutcome
{
	int ExitCode = -1;
	std::string Out;
	std::string Err;
};

class DrydockProgram : public testing::Test
{
protected:
	DrydockProgram()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_program_" + std::to_string(getpid())))
	{
		std::filesystem::remove_all(Folder);
		std::filesystem::create_directories(Folder);
	}
	~DrydockProgram() override { std::filesystem::remove_all(Folder); }

	/** Arguments as a shell takes them; runs in the test's own folder. */
	FOutcome Call(const std::string& Arguments) const
	{
		const std::string Err = (Folder / "stderr.txt").string();
		const std::string Command =
			"cd '" + Folder.string() + "' && '" + Program + "' " + Arguments + " 2>'" + Err + "'";
		FOutcome Outcome;
		FILE* Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Outcome.Out.append(Buffer.data(), NumRead);
		}
		Outcome.ExitCode = WEXITSTATUS(pclose(Pipe));
		std::ifstream Stream(Err);
		Outcome.Err = std::string(std::istreambuf_iterator<char>(Stream), {});
		return Outcome;
	}

	std::string Write(const std::string& Name, const std::string& Text) const
	{
		std::ofstream(Folder / Name, std::ios::binary) << Text;
		return (Folder / Name).string();
	}

	bool Exists(const std::string& Name) const { return std::filesystem::exists(Folder / Name); }

	const std::filesystem::path Folder;
};

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

std::string ReadFile(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

int CountLines(const std::string& Text, const std::string& Part)
{
	int Count = 0;
	for (size_t At = Text.find(Part); At != std::string::npos; At = Text.find(Part, At + 1))
	{
		++Count;
	}
	return Count;
}

} // namespace

TEST_F(DrydockProgram, VersionIsOneLine)
{
	const FOutcome Outcome = Call("--version");
	EXPECT_EQ(0, Outcome.ExitCode);
	EXPECT_EQ(0u, Outcome.Out.find("drydock "));
}

TEST_F(DrydockProgram, HelpNamesEveryVerb)
{
	const FOutcome Outcome = Call("--help");
	EXPECT_EQ(0, Outcome.ExitCode);
	for (const char* Verb : {"run", "check", "graph", "list"})
	{
		EXPECT_TRUE(Contains(Outcome.Out, std::string("  ") + Verb + " ")) << Verb;
	}
}

TEST_F(DrydockProgram, EveryVerbsFileIsInTheHelpAndOnThePageOfVerbs)
{
	const std::string Page = ReadFile(DRYDOCK_TEST_SOURCE_DIR "/docs/verbs.md");
	const std::string Table = ReadFile(DRYDOCK_TEST_SOURCE_DIR "/pipeline/Program/VerbTable.inl");
	const std::regex Function("\nFVerbCall (Add\\w+)\\(");
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/pipeline/Program"))
	{
		const std::string File = Entry.path().filename().string();
		if (!std::regex_match(File, std::regex("Verb[A-Z]\\w*\\.cpp")) || File == "VerbOptions.cpp")
		{
			continue;
		}
		const std::string Source = ReadFile(Entry.path());
		std::sregex_iterator Added(Source.begin(), Source.end(), Function);
		EXPECT_NE(std::sregex_iterator(), Added) << File << " adds no verb";
		for (; Added != std::sregex_iterator(); ++Added)
		{
			EXPECT_TRUE(Contains(Table, ", " + (*Added)[1].str() + ", \""))
				<< File << ": VerbTable.inl has no row of it";
		}
	}
	const std::regex Row("\nDRYDOCK_(?:VERB|TOOL)\\(\"(\\w+ )?(\\w+)\"");
	std::sregex_iterator Verb(Table.begin(), Table.end(), Row);
	EXPECT_NE(std::sregex_iterator(), Verb);
	for (; Verb != std::sregex_iterator(); ++Verb)
	{
		const std::string Above = (*Verb)[1];
		const std::string Name = (*Verb)[2];
		EXPECT_TRUE(Contains(Call(Above + "--help").Out, "\n  " + Name + " ")) << Name;
		EXPECT_TRUE(Contains(Page, "\n| `" + Above + Name + " ")) << "docs/verbs.md has no row of " << Name;
	}
}

TEST_F(DrydockProgram, HelpListsVerbsByTheirGroupsAndPlaces)
{
	const std::string Help = Call("--help").Out;
	size_t Last = 0;
	for (const char* Verb : {"Run:", "run", "check", "import", "warm", "blend", "graph", "probe", "trace", "explain",
			 "prove", "hazards", "lint", "study", "diff", "sheet", "list", "settings", "new", "build", "matrix",
			 "completion", "man", "schema"})
	{
		const bool bHeading = std::string(Verb).back() == ':';
		const size_t Place = Help.find(bHeading ? "\n" + std::string(Verb) + "\n" : "\n  " + std::string(Verb) + " ");
		EXPECT_NE(std::string::npos, Place) << Verb << "\n" << Help;
		EXPECT_LT(Last, Place) << Verb;
		Last = Place;
	}
}

TEST_F(DrydockProgram, NoVerbIsAUsageErrorThatNamesThemAll)
{
	const FOutcome Outcome = Call("");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_EQ("", Outcome.Out);
	EXPECT_EQ(0u, Outcome.Err.find("drydock: a verb is missing\n"));
	EXPECT_TRUE(Contains(Outcome.Err, "\nRun\n  run         Run the frame of a config")) << Outcome.Err;
}

TEST_F(DrydockProgram, VerbUnderAVerbCanBeMissingToo)
{
	EXPECT_TRUE(Contains(Call("settings").Err, "a verb is missing after settings"));
}

TEST_F(DrydockProgram, UnknownVerbNamesTheNearest)
{
	const FOutcome Outcome = Call("rnu a.json");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Err, "did you mean run?")) << Outcome.Err;
}

TEST_F(DrydockProgram, UnknownFlagNamesTheNearest)
{
	const FOutcome Outcome = Call("run --precison double a.json");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Err, "did you mean --precision?")) << Outcome.Err;
}

TEST_F(DrydockProgram, WrongChoiceIsAUsageError)
{
	EXPECT_EQ(2, Call("run --precision quad " + Configs + "neutral.json").ExitCode);
	EXPECT_EQ(2, Call("run --threads -1 " + Configs + "neutral.json").ExitCode);
	EXPECT_EQ(2, Call("graph --format pdf " + Configs + "neutral.json").ExitCode);
}

TEST_F(DrydockProgram, RunWritesEverythingAndSaysWhereThePictureIs)
{
	const FOutcome Outcome = Call("run " + Configs + "neutral.json");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_TRUE(Contains(Outcome.Out, "out/neutral/final.png")) << Outcome.Out;
	for (const char* Name :
		{"final.png", "final.exr", "scene_linear.exr", "run.json", "timing.json", "graph.dot", "trace.json"})
	{
		EXPECT_TRUE(Exists(std::string("out/neutral/") + Name)) << Name;
	}
}

TEST_F(DrydockProgram, ExecPrintsWhatIsAskedInTheGivenOrder)
{
	const FOutcome Outcome = Call("check --exec 'r.BloomQuality' --set r.BloomQuality=2 --exec r.BloomQuality "
								  "--exec 'r.BloomQuality 1,r.BloomQuality' " +
								  Configs + "neutral.json");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	const size_t First = Outcome.Err.find("r.BloomQuality = \"5\"      LastSetBy: Constructor");
	const size_t Second = Outcome.Err.find("r.BloomQuality = \"2\"      LastSetBy: Commandline");
	const size_t Third = Outcome.Err.find("r.BloomQuality = \"1\"      LastSetBy: Console");
	EXPECT_TRUE(First < Second && Second < Third && Third != std::string::npos) << Outcome.Err;
}

TEST_F(DrydockProgram, UnknownExecNameIsAnError)
{
	const FOutcome Outcome = Call("check --exec 'r.BloomQualty 2' " + Configs + "neutral.json");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Err, "DD1013 at --exec: unknown console variable r.BloomQualty; did you mean "
									  "r.BloomQuality?"))
		<< Outcome.Err;
}

TEST_F(DrydockProgram, ListOfOneVariableIsItsHelp)
{
	const FOutcome Outcome = Call("list cvars r.bloomquality --set sg.PostProcessQuality=1");
	EXPECT_TRUE(Contains(Outcome.Out, "HELP for 'r.BloomQuality':\n")) << Outcome.Out;
	EXPECT_TRUE(Contains(Outcome.Out, "r.BloomQuality = \"4\"      LastSetBy: Scalability\n")) << Outcome.Out;
}

TEST_F(DrydockProgram, ListShowsVariablesAsAConfigSetsThem)
{
	const std::string Config = Write("a.json", R"({"cvars": {"r.BloomQuality": 2}})");
	EXPECT_TRUE(Contains(Call("list cvars r.BloomQuality --json --config " + Config).Out,
		"\"value\": \"2\", \"default\": \"5\", \"setBy\": \"ConsoleVariablesIni\""));
	EXPECT_TRUE(Contains(Call("list cvars r.Blomqality").Err, "did you mean"));
}

TEST_F(DrydockProgram, WalkOfTheSceneWritesATableAndAChart)
{
	const FOutcome Outcome = Call("blend " + Configs + "volumes_walk.json --path scene --steps 1 --out walk");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_TRUE(Contains(Outcome.Out, "settings  BloomIntensity, ")) << Outcome.Out;
	// The weights of the scene's README at frame 4, four digits.
	EXPECT_TRUE(std::regex_search(Outcome.Out, std::regex("\n +4 +[0-9.]+ +1.0000 +1.0000 +0.6786\n"))) << Outcome.Out;
	std::ifstream Csv(Folder / "walk/walk.csv");
	const std::string Table(std::istreambuf_iterator<char>(Csv), {});
	EXPECT_EQ(1 + 8 + 7, std::count(Table.begin(), Table.end(), '\n'));
	EXPECT_TRUE(Exists("walk/walk.svg"));
	EXPECT_EQ(2, std::distance(std::filesystem::directory_iterator(Folder / "walk"), {})); // nothing left aside
}

TEST_F(DrydockProgram, ShippedChartIsTheOneThatIsDrawn)
{
	Call("blend " + Configs + "volumes_walk.json --path scene --out walk");
	std::ifstream Drawn(Folder / "walk/walk.svg");
	std::ifstream Shipped(Configs + "../docs/images/volumes_walk.svg");
	EXPECT_EQ(std::string(std::istreambuf_iterator<char>(Shipped), {}),
		std::string(std::istreambuf_iterator<char>(Drawn), {}))
		<< "redraw it: ./dev blend configs/volumes_walk.json --path scene; cp out/volumes_walk/walk.svg "
		   "docs/images/volumes_walk.svg";
}

TEST_F(DrydockProgram, WalkMistakesEndBeforeAnythingIsWritten)
{
	const std::string Path = Write("path.json", "[{\"location\": [0, 0, 0]},\n {\"location\": [1, 2]}]");
	const FOutcome Outcome = Call("blend " + Configs + "volumes_walk.json --out walk --path " + Path);
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Err, "path.json:2:15: error DD1006")) << Outcome.Err;
	EXPECT_EQ(2, Call("blend " + Configs + "neutral.json --out walk --path scene").ExitCode);
	EXPECT_EQ(3, Call("blend " + Configs + "neutral.json --out walk --path nowhere.json").ExitCode);
	EXPECT_EQ(2, Call("blend " + Configs + "neutral.json --at 0,0,0 --path scene").ExitCode);
	EXPECT_FALSE(Exists("walk"));
}

TEST_F(DrydockProgram, RepeatedOptionsTakeOneValueEach)
{
	const FOutcome Outcome = Call("run --set r.BloomQuality=1 --pp BloomIntensity=0 --set r.Tonemapper.Quality=1 " +
								  Configs + "neutral.json --out here");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_TRUE(Exists("here/final.png"));
}

TEST_F(DrydockProgram, JsonGoesToStdoutAlone)
{
	const FOutcome Outcome = Call("run --json " + Configs + "neutral.json");
	EXPECT_EQ(0u, Outcome.Out.find("{\n  \"version\""));
	EXPECT_EQ('\n', Outcome.Out.back());
}

TEST_F(DrydockProgram, ConfiguredEffectThatDoesNotRunHasAClosingLine)
{
	const FOutcome Outcome = Call("run --pp BloomToonIntensity=0.1 " + Configs + "neutral.json");
	EXPECT_EQ(0, Outcome.ExitCode);
	EXPECT_EQ(1, CountLines(Outcome.Err, "ToonBloom: there is no bloom to mask: BloomIntensity is 0"));
	EXPECT_FALSE(Contains(Call("run " + Configs + "neutral.json").Err, "ToonBloom"));
}

TEST_F(DrydockProgram, FiveMistakesFiveMessagesExitTwoNothingWritten)
{
	const std::string Config = Write(
		"a.json", R"({"scen": 1, "volumes": [{"bUnbound": true, "Settings": {"BloomIntensty": 1, "FilmToe": "x"}}],
		"cvars": {"r.BloomQualty": 5}, "showFlags": {"Blom": true}})");
	const FOutcome Outcome = Call("run " + Config);
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_EQ(5, CountLines(Outcome.Err, "error DD1")) << Outcome.Err;
	EXPECT_EQ(4, CountLines(Outcome.Err, "did you mean")) << Outcome.Err;
	EXPECT_EQ("", Outcome.Out);
	EXPECT_FALSE(Exists("out"));
}

TEST_F(DrydockProgram, MissingConfigIsExitThree)
{
	EXPECT_EQ(3, Call("run none.json").ExitCode);
	EXPECT_EQ(3, Call("check none.json").ExitCode);
}

TEST_F(DrydockProgram, MissingAndTruncatedScenesAreOneMessageAndExitThree)
{
	std::ifstream Scene(Configs + "scenes/two_boxes.exr", std::ios::binary);
	const std::string Bytes(std::istreambuf_iterator<char>(Scene), {});
	Write("cut.exr", Bytes.substr(0, Bytes.size() / 2));
	for (const char* Name : {"cut.exr", "none.exr"})
	{
		const FOutcome Outcome = Call("run " + Write("a.json", std::string(R"({"scene": {"file": ")") + Name + "\"}}"));
		EXPECT_EQ(3, Outcome.ExitCode) << Name;
		EXPECT_EQ(1, CountLines(Outcome.Err, "\n")) << Outcome.Err;
		EXPECT_FALSE(Exists("out"));
	}
}

TEST_F(DrydockProgram, OutputFolderThatIsAFileIsExitThree)
{
	Write("file", "");
	EXPECT_EQ(3, Call("run --out file " + Configs + "neutral.json").ExitCode);
}

TEST_F(DrydockProgram, NonFiniteByPolicyIsExitOne)
{
	// A pre-exposure that takes bright pixels beyond float.
	const std::string Config =
		Write("a.json", R"({"scene": {"file": ")" + Configs + R"(scenes/two_boxes.exr"}, "view": {"preExposure": 1e38},
		"cvars": {"r.Drydock.NonFinite": 2, "r.Drydock.Storage": 1}})");
	EXPECT_EQ(1, Call("run " + Config).ExitCode);
}

TEST_F(DrydockProgram, CheckRunsNothing)
{
	const FOutcome Outcome = Call("check " + Configs + "toon_bloom.json");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_TRUE(Contains(Outcome.Out, "no errors"));
	EXPECT_FALSE(Exists("out"));
}

TEST_F(DrydockProgram, CheckPrintsMessagesAsJson)
{
	const FOutcome Outcome = Call("check --json " + Write("a.json", R"({"scen": 1})"));
	EXPECT_EQ(2, Outcome.ExitCode);
	const nlohmann::json Message = nlohmann::json::parse(Outcome.Out).at("messages").at(0);
	EXPECT_EQ("DD1005", Message.at("code"));
	EXPECT_EQ("/scen", Message.at("pointer"));
	EXPECT_EQ("scene", Message.at("nearest"));
	EXPECT_EQ(1, Message.at("line"));
	EXPECT_EQ("", Outcome.Err);
}

TEST_F(DrydockProgram, GraphPrintsPassesMemoryAndReasonsWithoutRunning)
{
	const FOutcome Outcome = Call("graph " + Configs + "bloom_threshold.json");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_TRUE(Contains(Outcome.Out, "BloomSetup"));
	EXPECT_TRUE(Contains(Outcome.Out, "Tonemap"));
	EXPECT_TRUE(Contains(Outcome.Out, "alias"));
	EXPECT_FALSE(Exists("out"));
}

TEST_F(DrydockProgram, GraphHasItsFormats)
{
	EXPECT_EQ(0u, Call("graph --format dot " + Configs + "neutral.json").Out.find("digraph"));
	EXPECT_EQ(0u, Call("graph --format json " + Configs + "neutral.json").Out.find("{\n  \"name\""));
	const FOutcome Svg = Call("graph --format svg " + Configs + "neutral.json");
	EXPECT_TRUE(Svg.ExitCode == 0 ? Contains(Svg.Out, "<svg") : Svg.ExitCode == 3 && Contains(Svg.Err, "Graphviz"));
}

TEST_F(DrydockProgram, ListsHaveDefaults)
{
	EXPECT_TRUE(Contains(Call("list settings").Out, "BloomIntensity"));
	EXPECT_TRUE(Contains(Call("list cvars r.Bloom").Out, "r.BloomQuality"));
	EXPECT_FALSE(Contains(Call("list cvars r.Bloom").Out, "r.RDG.CullPasses"));
	EXPECT_TRUE(Contains(Call("list effects").Out, "ToonBloom"));
	EXPECT_TRUE(Contains(Call("list shaders").Out, ".usf"));
	EXPECT_TRUE(Contains(Call("list passes").Out, "Threshold = 1 (-1 .. 1e+06)"));
	EXPECT_TRUE(Contains(Call("list passes --config " + Configs + "neutral.json").Out, "Tonemap 960x540 (PS)"));
	EXPECT_TRUE(Contains(Call("list extensions").Out, "DualKawaseBlur"));
	EXPECT_EQ(0u, Call("list settings --json").Out.find("[\n"));
}

TEST_F(DrydockProgram, ListOfASettingThatIsNotThereNamesTheNearest)
{
	const FOutcome Outcome = Call("list settings BloomIntensty");
	EXPECT_EQ("", Outcome.Out);
	EXPECT_TRUE(Contains(Outcome.Err, "no setting matches \"BloomIntensty\"; did you mean BloomIntensity?"));
}

TEST_F(DrydockProgram, UnknownListNamesTheNearest)
{
	const FOutcome Outcome = Call("list setings");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Err, "did you mean settings?"));
}

TEST_F(DrydockProgram, BlendTellsTheStoryOfWhatChanged)
{
	Write("a.json", R"({"view": {"location": [0, 0, 150]}, "volumes": [
		{"name": "Stage", "bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 50}, "BlendRadius": 200,
			"Settings": {"BloomSizeScale": 8}},
		{"name": "Far", "bounds": {"type": "sphere", "center": [5000, 0, 150], "radius": 50}, "Priority": 1,
			"Settings": {"BloomSizeScale": 9, "FilmSlope": 1}}]})");
	const FOutcome Outcome = Call("blend a.json");
	EXPECT_EQ(0, Outcome.ExitCode);
	// 100 of 200 away: half way from 4 to 8.
	EXPECT_TRUE(Contains(Outcome.Out, "BloomSizeScale = 6\n"));
	EXPECT_TRUE(Contains(Outcome.Out, "out of radius: 4950.0 cm away, BlendRadius 100.0"));
	EXPECT_FALSE(Contains(Outcome.Out, "FilmSlope ="));
	EXPECT_TRUE(Contains(Outcome.Out, "nothing that names them acts here: FilmSlope"));
}

TEST_F(DrydockProgram, BlendEndsWithWhatExtensionsDo)
{
	Write("a.json", R"({"plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libTestPlugin.so"],
		"cvars": {"r.TestPlugin.Enabled": 1}})");
	const FOutcome Outcome = Call("blend a.json");
	EXPECT_EQ(0, Outcome.ExitCode);
	EXPECT_TRUE(Contains(Outcome.Out, "VignetteIntensity = 0.75\n"));
	EXPECT_TRUE(Contains(Outcome.Out, "FTestPluginExtension"));
}

TEST_F(DrydockProgram, BlendAtAnotherPlace)
{
	Write("a.json", R"({"volumes": [{"bounds": {"type": "sphere", "center": [-100, 0, 0], "radius": 1},
		"Settings": {"BloomSizeScale": 8}}]})");
	EXPECT_TRUE(Contains(Call("blend a.json --at -100,0,0").Out, "BloomSizeScale = 8\n"));
	EXPECT_FALSE(Contains(Call("blend a.json --at 500,0,0").Out, "BloomSizeScale ="));
	EXPECT_TRUE(Contains(Call("blend a.json --at 500,0,0 --setting BloomSize*").Out, "BloomSizeScale = 4\n"));
}

TEST_F(DrydockProgram, BlendTakesVariablesOfConfigAndCommandLine)
{
	Write("a.json", R"({"cvars": {"r.ExposureOffset": 0.5}, "showFlags": {"Bloom": false}})");
	const std::string Out = Call("blend a.json --pp BloomSizeScale=8").Out;
	EXPECT_TRUE(Contains(Out, "AutoExposureBias = 1.5"));
	EXPECT_TRUE(Contains(Out, "BloomIntensity = 0\n"));
	EXPECT_TRUE(Contains(Out, "BloomSizeScale = 8\n"));
	EXPECT_TRUE(Contains(Call("blend a.json --set r.ExposureOffset=2").Out, "AutoExposureBias = 3"));
}

TEST_F(DrydockProgram, BlendJsonHasTheWholeLedger)
{
	Write("a.json", R"({"volumes": [{"name": "All", "bUnbound": true, "BlendWeight": 0.5,
		"Settings": {"BloomSizeScale": 8}}]})");
	const nlohmann::json Root = nlohmann::json::parse(Call("blend a.json --at 1,2,3 --json").Out);
	EXPECT_EQ(nlohmann::json({1, 2, 3}), Root["location"]);
	EXPECT_EQ(6, Root["settings"]["BloomSizeScale"]);
	EXPECT_EQ(0.675, Root["settings"]["BloomIntensity"]);
	const nlohmann::json Expected = {{"source", "All"}, {"kind", "volume"}, {"rule", "Lerp"}, {"weight", 0.5},
		{"distance", nullptr}, {"before", 4}, {"after", 6}, {"skipped", nullptr}};
	EXPECT_EQ(Expected, Root["ledger"]["BloomSizeScale"][1]);
	EXPECT_EQ(1u, Root["ledger"]["BloomIntensity"].size());
}

TEST_F(DrydockProgram, BlendAnswersMistakes)
{
	Write("a.json", "{}");
	const FOutcome Setting = Call("blend a.json --setting BloomIntensty");
	EXPECT_EQ(2, Setting.ExitCode);
	EXPECT_TRUE(Contains(Setting.Err, "unknown setting BloomIntensty; did you mean BloomIntensity?"));
	for (const char* Place : {"1,2", "1,2,3,4", "1,2,x", "nan,0,0", "1e999,0,0"})
	{
		const FOutcome Outcome = Call(std::string("blend a.json --at '") + Place + "'");
		EXPECT_EQ(2, Outcome.ExitCode) << Place;
		EXPECT_EQ("", Outcome.Out) << Place;
	}
}
