// Runs in this process: what ends up in the graph and in the pictures, and what is wrong with either.
#include "RunTestScene.h"

using namespace Drydock;
using namespace RunTest;

TEST(RunGraph, DefaultsHaveOneDownsampleChainTwelveBlursATableAndATonemapper)
{
	// Half resolution and five levels below it, an X and a Y pass for each of six Gaussians, the combined colour
	// grading table, the tonemapper.
	const FRunResult Result = Compile("");
	EXPECT_EQ(6 + 12 + 2, CountPasses(Result.Graph, false));
	EXPECT_EQ(0, CountPasses(Result.Graph, true));
	EXPECT_EQ(0, CountNamed(Result.Graph, "BloomSetup"));
}

TEST(RunGraph, ThresholdAddsTheSetupAndCullsTheScenesOwnChain)
{
	const FRunResult Result = Compile(R"("camera": {"Settings": {"BloomThreshold": 1}})");
	EXPECT_EQ(1, CountNamed(Result.Graph, "BloomSetup"));
	EXPECT_EQ(6 + 1 + 12 + 2, CountPasses(Result.Graph, false));
	EXPECT_EQ(5, CountPasses(Result.Graph, true));
}

TEST(RunGraph, CulledPassesSayWhy)
{
	const FRunResult Result = Compile(R"("camera": {"Settings": {"BloomThreshold": 1}})");
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		EXPECT_EQ(Pass.bCulled, !Result.Graph.DescribeCulled(Pass).empty()) << Pass.Name;
	}
}

TEST(RunGraph, NoBloomLeavesTheTonemapperAndItsTable)
{
	const FRunResult Result = Compile(R"("camera": {"Settings": {"BloomIntensity": 0}})");
	EXPECT_EQ(2, CountPasses(Result.Graph, false) + CountPasses(Result.Graph, true));
}

TEST(RunGraph, LowQualityDropsTheNarrowGaussians)
{
	const FRunResult Result = Compile(R"("cvars": {"r.BloomQuality": 3})");
	EXPECT_EQ(4 * 2, CountNamed(Result.Graph, "Bloom"));
	EXPECT_EQ(0, CountNamed(Result.Graph, "Bloom1"));
}

TEST(RunGraph, CompilingExecutesAndDecodesNothing)
{
	const FRunResult Result = Compile("");
	EXPECT_TRUE(Result.Passes.empty());
	EXPECT_TRUE(Result.Final.ToImage().Values.empty());
	EXPECT_TRUE(std::none_of(
		Result.Channels.begin(), Result.Channels.end(), [](const FSceneChannel& Channel) { return Channel.bDecoded; }));
}

TEST(RunGraph, AliasingSavesMemory)
{
	const FRDGMemory Memory = Compile("").Graph.Memory;
	EXPECT_GT(Memory.TransientPeakBytes, 0u);
	EXPECT_LT(Memory.TransientPeakBytes, Memory.WithoutAliasingBytes);
}

TEST(RunFrame, PicturesHaveTheScenesSize)
{
	const FRunResult Result = RunConfig(SmallScene());
	EXPECT_EQ(641, Result.Final.Width);
	EXPECT_EQ(359, Result.Final.Height);
	EXPECT_EQ(641u * 359u * 4u, Result.SceneLinear.ToImage().Values.size());
}

TEST(RunFrame, SceneLinearIsTheSceneFile)
{
	const FRunResult Result = RunConfig(SmallScene());
	FImageFile File(Root + "configs/scenes/toon_character_641x359.exr");
	const std::vector<float> Green = File.Read({File.FindChannel("G")})[0];
	EXPECT_EQ(static_cast<double>(Green[100 * 641 + 200]), Result.SceneLinear.Get(200, 100, 1));
	EXPECT_EQ(static_cast<double>(Green.back()), Result.SceneLinear.Get(640, 358, 1));
}

TEST(RunFrame, PreExposureMultipliesWhatIsStoredAndNotThePicture)
{
	const FRunResult Plain = RunConfig(SmallScene());
	const FRunResult Exposed = RunConfig(SmallScene(R"("view": {"preExposure": 0.5})"));
	EXPECT_EQ(0.5 * Plain.SceneLinear.Get(200, 100, 1), Exposed.SceneLinear.Get(200, 100, 1));
	EXPECT_LE(MaxDifference(Plain.Final.ToImage(), Exposed.Final.ToImage()),
		2.5 / 255.0); // formats round a halved image elsewhere
}

TEST(RunFrame, TheVariableOverridesPreExposure)
{
	const FRunResult Exposed = RunConfig(SmallScene(R"("view": {"preExposure": 0.25})"));
	const FRunResult Overridden =
		RunConfig(SmallScene(R"("view": {"preExposure": 8}, "cvars": {"r.EyeAdaptation.PreExposureOverride": 0.25})"));
	EXPECT_EQ(Exposed.SceneLinear.ToImage().Values, Overridden.SceneLinear.ToImage().Values);
	EXPECT_EQ(Exposed.Final.ToImage().Values, Overridden.Final.ToImage().Values);
	EXPECT_EQ(0.25, Overridden.Config.View.PreExposure.Value);
}

TEST(RunFrame, BloomBrightens)
{
	const FRunResult Off = RunConfig(SmallScene(R"("camera": {"Settings": {"BloomIntensity": 0}})"));
	const FRunResult On = RunConfig(SmallScene(R"("camera": {"Settings": {"BloomIntensity": 2}})"));
	double SumOff = 0.0;
	double SumOn = 0.0;
	const FImage OnFinal = On.Final.ToImage();
	const FImage OffFinal = Off.Final.ToImage();
	for (size_t Index = 0; Index < OnFinal.Values.size(); ++Index)
	{
		SumOff += OffFinal.Values[Index];
		SumOn += OnFinal.Values[Index];
	}
	EXPECT_GT(SumOn, 1.02 * SumOff);
}

TEST(RunFrame, OnlyColourIsDecoded)
{
	for (const FSceneChannel& Channel : RunConfig(SmallScene()).Channels)
	{
		EXPECT_EQ(Channel.Name.size() == 1, Channel.bDecoded) << Channel.Name;
	}
}

namespace
{

/** r.BloomQuality while a run with these is set up, "value setter". */
std::string BloomQualityOf(const FRunOptions& Options, std::vector<FDiagnostic>* OutDiagnostics = nullptr)
{
	const FRunSetup Setup(Options);
	const IConsoleVariable* Quality = IConsoleManager::Get().FindConsoleVariable(TEXT("r.BloomQuality"));
	if (OutDiagnostics != nullptr)
	{
		*OutDiagnostics = Setup.Diagnostics;
	}
	return std::string(*Quality->GetString()) + " " + GetConsoleVariableSetByName(Quality->GetFlags());
}

} // namespace

TEST(RunVariables, ConsoleBeatsCommandLineBeatsConfigBeatsScalability)
{
	FRunOptions Options = SmallScene();
	Options.ConfigText = R"({"cvars": {"sg.PostProcessQuality": 1}})";
	EXPECT_EQ("4 Scalability", BloomQualityOf(Options));
	Options.ConfigText = R"({"cvars": {"r.BloomQuality": 1, "sg.PostProcessQuality": 1}})";
	EXPECT_EQ("1 ConsoleVariablesIni", BloomQualityOf(Options));
	Options.Variables = {"r.BloomQuality=2", "sg.PostProcessQuality=0"};
	EXPECT_EQ("2 Commandline", BloomQualityOf(Options));
	Options.Exec = {{"r.BloomQuality 3", 0}};
	EXPECT_EQ("3 Console", BloomQualityOf(Options));
}

TEST(RunVariables, OfOneSourceTheLastWins)
{
	FRunOptions Options = SmallScene();
	Options.Variables = {"r.BloomQuality=2", "r.BLOOMQUALITY=1"};
	EXPECT_EQ("1 Commandline", BloomQualityOf(Options));
	Options.Exec = {{"r.BloomQuality 3, r.BloomQuality=4", 2}};
	EXPECT_EQ("4 Console", BloomQualityOf(Options));
}

TEST(RunVariables, SetThatIsKeptOutWarnsInTheEnginesWords)
{
	FRunOptions Options = SmallScene();
	Options.Variables = {"r.BloomQuality=2"};
	Options.Exec = {{"r.BloomQuality 3", 0}}; // before the --set
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_EQ("3 Console", BloomQualityOf(Options, &Diagnostics));
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(1022, Diagnostics[0].Code);
	EXPECT_EQ(
		"Setting the console variable 'r.BloomQuality' with 'SetByCommandline' was ignored as it is lower priority "
		"than the previous 'SetByConsole'. Value remains '3'",
		Diagnostics[0].Message);
}

TEST(RunVariables, SinksRunBeforeTheFrame)
{
	int32 Seen = 0;
	FAutoConsoleVariableSink Sink(FConsoleCommandDelegate::CreateLambda(
		[&Seen]() { Seen = IConsoleManager::Get().FindConsoleVariable(TEXT("r.BloomQuality"))->GetInt(); }));
	FRunOptions Options = SmallScene();
	Options.Variables = {"r.BloomQuality=2"};
	BloomQualityOf(Options);
	EXPECT_EQ(2, Seen);
}

TEST(RunFrame, ViewRectCropsThePicture)
{
	const FRunResult Result = RunConfig(SmallScene(R"("view": {"rect": [100, 50, 301, 151]})"));
	EXPECT_EQ(201, Result.Final.Width);
	EXPECT_EQ(101, Result.Final.Height);
}

TEST(RunFrame, VariablesAreAsBeforeAfterwards)
{
	const IConsoleVariable* Quality = IConsoleManager::Get().FindConsoleVariable(TEXT("r.BloomQuality"));
	const int32 Before = Quality->GetInt();
	RunConfig(SmallScene(R"("cvars": {"r.BloomQuality": 1})"));
	EXPECT_EQ(Before, Quality->GetInt());
	EXPECT_EQ("none", ErrorOf(SmallScene()));
}

TEST(RunFrame, CommandLineBeatsTheConfig)
{
	FRunOptions Options =
		SmallScene(R"("cvars": {"r.BloomQuality": 1}, "camera": {"Settings": {"BloomIntensity": 3}})");
	Options.bExecute = false;
	Options.Variables = {"r.BloomQuality=5"};
	Options.Settings = {"BloomIntensity=0.25"};
	const FRunResult Result = RunConfig(Options);
	EXPECT_EQ(6 * 2, CountNamed(Result.Graph, "Bloom"));
	EXPECT_EQ(0.25f, Result.Settings.BloomIntensity);
}

TEST(RunErrors, ConfigWithoutAScene)
{
	FRunOptions Options;
	Options.ConfigFile = "a.json";
	Options.ConfigText = "{}";
	EXPECT_EQ("1008 2", ErrorOf(Options));
}

TEST(RunErrors, MissingScene)
{
	FRunOptions Options = SmallScene();
	Options.ConfigText = R"({"scene": {"file": "scenes/none.exr"}})";
	EXPECT_EQ("5001 3", ErrorOf(Options));
}

TEST(RunErrors, MissingChannelNamesChannelPassAndTheWayOut)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	WriteExr((Folder / "rg.exr").string(), {2, 2, 2, std::vector<double>(8, 0.5)}, {"R", "G"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "rg.exr"}})";
	EXPECT_EQ("5003 3", ErrorOf(Options));
	try
	{
		RunConfig(Options);
	}
	catch (const FError& Error)
	{
		const std::string& Message = Error.GetDiagnostics()[0].Message;
		EXPECT_NE(std::string::npos, Message.find("channel \"B\"")) << Message;
		EXPECT_NE(std::string::npos, Message.find("pass ")) << Message;
		EXPECT_NE(std::string::npos, Message.find("scene.defaults")) << Message;
	}
	Options.ConfigText = R"({"scene": {"file": "rg.exr", "defaults": {"B": 0.25}}})";
	EXPECT_EQ(0.25, RunConfig(Options).SceneLinear.Get(1, 1, 2));
	Options.ConfigText = R"({"scene": {"file": "rg.exr", "channels": {"B": "G"}}})";
	EXPECT_EQ(0.5, RunConfig(Options).SceneLinear.Get(1, 1, 2));
	std::filesystem::remove_all(Folder);
}

TEST(RunErrors, ChannelNamesAreChecked)
{
	FRunOptions Options = SmallScene();
	Options.ConfigText = R"({"scene": {"file": "scenes/two_boxes.exr", "channels": {"R": "Red"}}})";
	EXPECT_EQ("1007 2", ErrorOf(Options));
	Options.ConfigText = R"({"scene": {"file": "scenes/two_boxes.exr", "defaults": {"Dept.Z": 1}}})";
	EXPECT_EQ("1007 2", ErrorOf(Options));
}

TEST(RunErrors, RectOutsideTheScene)
{
	EXPECT_EQ("1010 2", ErrorOf(SmallScene(R"("view": {"rect": [0, 0, 642, 359]})")));
}

TEST(RunErrors, PlainPictureIsAScene)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	WritePng((Folder / "grey.png").string(), {64, 32, 3, std::vector<double>(64 * 32 * 3, 1.0)});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "grey.png"}})";
	const FRunResult Result = RunConfig(Options);
	EXPECT_EQ(1.0, Result.SceneLinear.Get(5, 5, 0));
	EXPECT_EQ(1.0, Result.SceneLinear.Get(5, 5, 3));
	std::filesystem::remove_all(Folder);
}

TEST(RunMistakes, ASettingThatNoEffectReadsIsAWarningAtItsPlace)
{
	FRunOptions Options;
	Options.ConfigFile = "a.json";
	Options.ConfigText = R"({"volumes": [{"bUnbound": true, "Settings": {"AmbientOcclusionBias": 2}}]})";
	Options.Settings = {"AmbientOcclusionBias=3"};
	const std::vector<FDiagnostic> Diagnostics = CheckConfig(Options).Diagnostics;
	ASSERT_EQ(2u, Diagnostics.size());
	EXPECT_EQ(WarnNotBuilt, Diagnostics[0].Code);
	EXPECT_EQ("a.json", Diagnostics[0].File);
	EXPECT_EQ(46, Diagnostics[0].Column);
	EXPECT_EQ("/volumes/0/Settings/AmbientOcclusionBias", Diagnostics[0].Where);
	EXPECT_EQ("command line", Diagnostics[1].File);
}
