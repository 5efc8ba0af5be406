// Runs in this process: what ends up in the graph, in the report and in the pictures. Past 500 lines: all cases share
// the small scene and the helpers that make and run it.
#include <gtest/gtest.h>

#include "Budget/RunOptions.h"
#include "Run/Run.h"
#include "Run/RunDump.h"
#include "Run/RunOutputs.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "Text/Json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>

using namespace Drydock;

namespace
{

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

/** A config of the odd-sized scene; More: further members of the root object. */
FRunOptions SmallScene(const std::string& More = "")
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/toon_character_641x359.exr"})" + (More.empty() ? "" : ", " + More) + "}";
	return Options;
}

FRunResult Compile(const std::string& More)
{
	FRunOptions Options = SmallScene(More);
	Options.bExecute = false;
	return RunConfig(Options);
}

int CountPasses(const FRDGCompiledGraph& Graph, bool bCulled)
{
	return static_cast<int>(std::count_if(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return !Pass.bIsSentinel && Pass.bCulled == bCulled; }));
}

/** Survivors whose name contains a text. */
int CountNamed(const FRDGCompiledGraph& Graph, const std::string& Part)
{
	return static_cast<int>(std::count_if(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass)
		{ return !Pass.bIsSentinel && !Pass.bCulled && Pass.Name.find(Part) != std::string::npos; }));
}

/** "code exit" of the first error. */
std::string ErrorOf(const FRunOptions& Options)
{
	try
	{
		RunConfig(Options);
	}
	catch (const FError& Error)
	{
		for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			if (Diagnostic.Severity == ESeverity::Error)
			{
				return std::to_string(Diagnostic.Code) + " " + std::to_string(Error.GetExitCode());
			}
		}
	}
	return "none";
}

FJsonValue ParseReport(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	FJsonValue Value = ParseJson(Text, "run.json", Diagnostics, bSyntaxError);
	EXPECT_TRUE(Diagnostics.empty());
	return Value;
}

double MaxDifference(const FImage& A, const FImage& B)
{
	double Largest = 0.0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		Largest = std::max(Largest, std::fabs(A.Values[Index] - B.Values[Index]));
	}
	return Largest;
}

std::filesystem::path MakeTemporaryFolder()
{
	const std::filesystem::path Folder =
		std::filesystem::temp_directory_path() / ("drydock_run_" + std::to_string(getpid()));
	std::filesystem::remove_all(Folder);
	return Folder;
}

std::string ReadBytes(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

} // namespace

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

TEST(RunNonFinite, IsCountedZeroedOrRefusedByPolicy)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{32, 16, 3, std::vector<double>(32 * 16 * 3, 0.5)};
	Image.Values[(7 * 32 + 9) * 3 + 1] = std::nan("");
	WriteExr((Folder / "nan.exr").string(), Image, {"R", "G", "B"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "nan.exr"}})";

	const FRunResult Result = RunConfig(Options);
	ASSERT_FALSE(Result.Diagnostics.empty());
	EXPECT_EQ(WarnNonFinite, Result.Diagnostics[0].Code);
	EXPECT_EQ("1 value is NaN or infinite, first at pixel (9, 7)", Result.Diagnostics[0].Message);
	EXPECT_TRUE(std::isnan(Result.SceneLinear.Get(9, 7, 1)));

	Options.Variables = {"r.Drydock.NonFinite=1"};
	EXPECT_EQ(0.0, RunConfig(Options).SceneLinear.Get(9, 7, 1));
	Options.Variables = {"r.Drydock.NonFinite=2"};
	EXPECT_EQ("4002 1", ErrorOf(Options));
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, PassesThatSpreadThemAndTheFinalPictureAreNamed)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{96, 64, 3, std::vector<double>(96 * 64 * 3, 0.05)};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Image.Values[static_cast<size_t>((20 * 96 + 30) * 3 + Channel)] = std::numeric_limits<double>::infinity();
	}
	WriteExr((Folder / "inf.exr").string(), Image, {"R", "G", "B"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "inf.exr"}})";
	Options.Dump = {"*"};
	const FRunResult Result = RunConfig(Options);
	Options.Variables = {"r.Drydock.NonFinite=1"};
	const FRunResult Zeroed = RunConfig(Options);

	// The largest share among the textures that passes wrote, counted in the dumps.
	double Largest = 0.0;
	std::string Pass;
	for (const FRunDump& Dump : Result.Dumps)
	{
		const FImage Image = Dump.Image.ToImage();
		const size_t NumChannels = static_cast<size_t>(Image.NumChannels);
		size_t NumBad = 0, NumPixels = Image.Values.size() / NumChannels;
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const double* const Values = &Image.Values[Pixel * NumChannels];
			NumBad +=
				std::all_of(Values, Values + NumChannels, [](double Value) { return std::isfinite(Value); }) ? 0 : 1;
		}
		const double Share = static_cast<double>(NumBad) / static_cast<double>(NumPixels);
		Pass = Dump.PassIndex > 0 && Share > Largest ? Dump.Pass : Pass;
		Largest = Dump.PassIndex > 0 ? std::max(Largest, Share) : Largest;
	}
	ASSERT_FALSE(Result.NonFinite.Passes.empty());
	EXPECT_EQ(Pass, Result.NonFinite.Passes.back().Pass);
	EXPECT_EQ(Largest, Result.NonFinite.Passes.back().GetShare());
	EXPECT_GT(Largest, 0.5); // bloom

	uint64_t NumChanged = 0, NumWhite = 0;
	const FImage ResultFinal = Result.Final.ToImage();
	const FImage ZeroedFinal = Zeroed.Final.ToImage();
	for (size_t Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		const double* const A = &ResultFinal.Values[4 * Pixel];
		const double* const B = &ZeroedFinal.Values[4 * Pixel];
		NumChanged += std::equal(A, A + 4, B) ? 0 : 1;
		NumWhite += A[0] == 1.0 && A[1] == 1.0 && A[2] == 1.0 && B[0] < 1.0 ? 1 : 0; // grey: all three or none
	}
	ASSERT_TRUE(Result.NonFinite.Final.has_value());
	EXPECT_EQ(96u * 64u, Result.NonFinite.Final->NumPixels);
	EXPECT_EQ(NumChanged, Result.NonFinite.Final->Changed);
	EXPECT_EQ(NumWhite, Result.NonFinite.Final->White);
	EXPECT_EQ(0u, Result.NonFinite.Final->NotFinite);
	const FDiagnostic& Said = Result.Diagnostics.back();
	EXPECT_EQ(WarnNonFiniteSpread, Said.Code);
	EXPECT_NE(std::string::npos, Said.Message.find(Pass)) << Said.Message;
	EXPECT_NE(std::string::npos, Said.Message.find(" " + std::to_string(NumWhite) + " (")) << Said.Message;

	EXPECT_TRUE(Zeroed.NonFinite.Passes.empty());
	EXPECT_FALSE(Zeroed.NonFinite.Final.has_value());
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, SceneColorClampCutsSpikesAndInfinitiesOnly)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{32, 16, 4, std::vector<double>(32 * 16 * 4, 0.5)};
	const auto At = [](int X, int Y, int Channel)
	{
		return static_cast<size_t>((Y * 32 + X) * 4 + Channel);
	};
	Image.Values[At(9, 7, 0)] = 60000.0; // a spike of a resolve
	Image.Values[At(9, 7, 1)] = 10.0;
	Image.Values[At(9, 7, 2)] = -20.0; // its ring
	Image.Values[At(9, 7, 3)] = 20.0;
	Image.Values[At(10, 7, 0)] = std::numeric_limits<double>::infinity();
	Image.Values[At(10, 7, 1)] = std::nan("");
	WriteExr((Folder / "spike.exr").string(), Image, {"R", "G", "B", "A"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "spike.exr"}})";
	const auto Color = [](const FRunResult& Result, int X)
	{
		return std::vector<double>{Result.SceneLinear.Get(X, 7, 0), Result.SceneLinear.Get(X, 7, 1),
			Result.SceneLinear.Get(X, 7, 2), Result.SceneLinear.Get(X, 7, 3)};
	};
	EXPECT_EQ((std::vector<double>{60000.0, 10.0, -20.0, 20.0}), Color(RunConfig(Options), 9));

	Options.Variables = {"r.Drydock.SceneColorClamp=10"};
	const FRunResult Clamped = RunConfig(Options);
	EXPECT_EQ((std::vector<double>{10.0, 10.0, -10.0, 20.0}), Color(Clamped, 9));
	EXPECT_EQ(10.0, Color(Clamped, 10)[0]);
	EXPECT_TRUE(std::isnan(Color(Clamped, 10)[1]));
	EXPECT_EQ("1 value is NaN or infinite, first at pixel (10, 7)", Clamped.Diagnostics[0].Message);

	// Clamp first, then the policy: infinity is cut off, NaN is zeroed.
	Options.Variables = {"r.Drydock.SceneColorClamp=10", "r.Drydock.NonFinite=1"};
	EXPECT_EQ((std::vector<double>{10.0, 0.0, 0.5, 0.5}), Color(RunConfig(Options), 10));
	Options.Variables = {"r.Drydock.SceneColorClamp=-3"}; // off
	EXPECT_EQ((std::vector<double>{60000.0, 10.0, -20.0, 20.0}), Color(RunConfig(Options), 9));
	std::filesystem::remove_all(Folder);
}

TEST(RunDumps, PatternsHaveStarsAndQuestionMarks)
{
	EXPECT_TRUE(MatchesPattern("*Blur*", "GaussianBlurX"));
	EXPECT_TRUE(MatchesPattern("Bloom?X", "Bloom1X"));
	EXPECT_TRUE(MatchesPattern("*", ""));
	EXPECT_TRUE(MatchesPattern("a*b*c", "a1b2bc"));
	EXPECT_FALSE(MatchesPattern("Bloom", "BloomSetup"));
	EXPECT_FALSE(MatchesPattern("Bloom?X", "BloomX"));
	EXPECT_FALSE(MatchesPattern("a*b*c", "a1b2b"));
	EXPECT_FALSE(MatchesPattern("", "a"));
}

TEST(RunDumps, FileNamesAreSafe)
{
	FRunDump Dump;
	Dump.PassIndex = 7;
	Dump.Pass = "Down/sample(High) 641x359 (PS)";
	Dump.Resource = "Half.Res";
	EXPECT_EQ("007.Down_sample.Half_Res", GetDumpFileName(Dump));
	Dump.Mip = 2;
	EXPECT_EQ("007.Down_sample.Half_Res.mip2", GetDumpFileName(Dump));
}

TEST(RunDumps, PatternsNamePassesInFullAndShort)
{
	const auto Fits = [](const char* Pattern)
	{
		return IsDumped({{Pattern, {}}}, "BloomSetup 480x270 (PS)", "Half");
	};
	EXPECT_TRUE(Fits("BloomSetup"));
	EXPECT_TRUE(Fits("BloomSetup 480x270 (PS)"));
	EXPECT_TRUE(Fits("BloomSetup.Half"));
	EXPECT_TRUE(Fits("Half"));
	EXPECT_FALSE(Fits("Bloom"));
	EXPECT_FALSE(Fits("BloomSetup.Full"));
}

TEST(RunDumps, KeepTheResourceAfterThePass)
{
	FRunOptions Options = SmallScene();
	Options.Dump = {"HalfResolutionSceneColor"};
	const FRunResult Result = RunConfig(Options);
	ASSERT_EQ(1u, Result.Dumps.size());
	EXPECT_EQ(1, Result.Dumps[0].PassIndex);
	EXPECT_EQ(321, Result.Dumps[0].Image.Width);
	EXPECT_EQ(180, Result.Dumps[0].Image.Height);
	EXPECT_EQ((std::vector<std::string>{"R", "G", "B"}), Result.Dumps[0].Channels);
}

TEST(RunDumps, HoldWhatWasDrawnAndNothingOfOtherTextures)
{
	// The glow's mask is drawn where the scene has one, in memory that is used again and again.
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/chara_glow.json";
	Options.Dump = {"CharaGlow*", "Bloom*"};
	const FRunResult Result = RunConfig(Options);
	int NumMasks = 0;
	for (const FRunDump& Dump : Result.Dumps)
	{
		const FIntRect Whole(0, 0, Dump.Image.Width, Dump.Image.Height);
		const FImage Part = Dump.Image.Crop(Dump.Window).ToImage();
		EXPECT_EQ(Dump.Window.Width(), Part.Width) << Dump.Resource;
		if (Dump.Resource == "CharaGlow" || Dump.Resource == "CharaGlowRows")
		{
			++NumMasks;
			EXPECT_LT(Dump.Window.Area(), Whole.Area()) << Dump.Resource;
			EXPECT_TRUE(std::all_of(
				Part.Values.begin(), Part.Values.end(), [](double Value) { return Value >= 0.0 && Value <= 1.0; }))
				<< Dump.Resource;
			for (int Y = 0; Y < Whole.Max.Y; ++Y)
			{
				for (int X = 0; X < Whole.Max.X; ++X)
				{
					EXPECT_TRUE(Dump.Window.Contains(FIntPoint(X, Y)) || Dump.Image.Get(X, Y, 0) == 0.0);
				}
			}
		}
		else if (Dump.Pass.starts_with("Bloom"))
		{
			EXPECT_EQ(Whole, Dump.Window) << Dump.Resource;
		}
	}
	EXPECT_EQ(2, NumMasks);
}

TEST(RunDumps, TheFilesDataWindowIsWhatWasDrawnByEitherKindOfPass)
{
	// A view of 320 x 240 at (64, 32) of textures that are larger: half of it at half the corner.
	for (const std::string Compute : {"0", "1"})
	{
		FRunOptions Options = SmallScene(R"("view": {"rect": [64, 32, 384, 272]})");
		Options.Variables = {"r.PostProcessing.PreferCompute=" + Compute};
		Options.Dump = {"HalfResolutionSceneColor"};
		const FRunResult Result = RunConfig(Options);
		ASSERT_EQ(1u, Result.Dumps.size());
		EXPECT_EQ(FIntRect(32, 16, 192, 136), Result.Dumps[0].Window) << Compute;

		const std::filesystem::path Folder = MakeTemporaryFolder();
		WriteRunOutputs(Result, (Folder / "a").string());
		const std::filesystem::path File = Folder / "a" / "passes" / GetDumpFileName(Result.Dumps[0]);
		const FImageFile Exr(File.string() + ".exr");
		EXPECT_EQ(160, Exr.GetWidth());
		EXPECT_EQ(120, Exr.GetHeight());
		EXPECT_EQ((FImageWindow{32, 16, Result.Dumps[0].Image.Width, Result.Dumps[0].Image.Height}), Exr.GetWindow());
		EXPECT_EQ(160, FImageFile(File.string() + ".png").GetWidth());
		std::filesystem::remove_all(Folder);
	}
}

TEST(RunDumps, ExternalInputsAreNumberZero)
{
	FRunOptions Options = SmallScene();
	Options.Dump = {"External.*"};
	const FRunResult Result = RunConfig(Options);
	ASSERT_EQ(1u, Result.Dumps.size());
	EXPECT_EQ("000.External.SceneColor", GetDumpFileName(Result.Dumps[0]));
	EXPECT_EQ(Result.SceneLinear.ToImage().Values, Result.Dumps[0].Image.ToImage().Values);
}

TEST(RunDumps, PatternsThatFitNothingWarn)
{
	FRunOptions Options = SmallScene(R"("camera": {"Settings": {"BloomThreshold": 1}})");
	Options.Dump = {"HalfResolutionSceneColour", "SceneDownsample*"};
	const FRunResult Result = RunConfig(Options);
	ASSERT_EQ(2u, Result.Diagnostics.size());
	EXPECT_EQ(WarnNothingDumped, Result.Diagnostics[0].Code);
	EXPECT_NE(std::string::npos, Result.Diagnostics[0].Message.find("did you mean HalfResolutionSceneColor?"));
	EXPECT_NE(std::string::npos, Result.Diagnostics[1].Message.find("fits only culled passes"));
}

TEST(RunDumps, ChangeNothing)
{
	FRunOptions Options = SmallScene();
	const FRunResult Plain = RunConfig(Options);
	Options.Dump = {"*"};
	const FRunResult Dumped = RunConfig(Options);
	EXPECT_EQ(Plain.Final.ToImage().Values, Dumped.Final.ToImage().Values);
	EXPECT_GE(Dumped.Dumps.size(), Dumped.Passes.size());
}

TEST(RunReport, HasTheFixedKeys)
{
	const FJsonValue Report = ParseReport(RunConfig(SmallScene()).RunJson);
	for (const char* Key : {"version", "config", "engine", "precision", "settings", "effects", "passes", "memory",
			 "channels", "outputs", "warnings", "exposure"})
	{
		EXPECT_NE(nullptr, Report.Find(Key)) << Key;
	}
	for (const char* Key :
		{"index", "name", "executed", "reason", "shader", "entry", "pixels", "taps", "bytesRead", "bytesWritten"})
	{
		EXPECT_NE(nullptr, Report.Find("passes")->Elements.at(0).Find(Key)) << Key;
	}
	EXPECT_EQ(0.675, Report.Find("settings")->Find("BloomIntensity")->Number);
	EXPECT_EQ(17u, Report.Find("channels")->Elements.size());
	EXPECT_EQ(GetEffects().size(), Report.Find("effects")->Elements.size());
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

TEST(RunReport, PassesCountTheirPixels)
{
	const FJsonValue Report = ParseReport(RunConfig(SmallScene()).RunJson);
	const FJsonValue& First = Report.Find("passes")->Elements.at(0);
	const FJsonValue& Last = Report.Find("passes")->Elements.back();
	EXPECT_EQ(1.0, First.Find("index")->Number);
	EXPECT_EQ(321.0 * 180.0, First.Find("pixels")->Number);
	EXPECT_EQ(641.0 * 359.0, Last.Find("pixels")->Number);
	EXPECT_TRUE(First.Find("executed")->Bool);
}

TEST(RunReport, SaysNothingOfThreads)
{
	FRunOptions Options = SmallScene();
	Options.Threads = 1;
	const std::string One = RunConfig(Options).RunJson;
	Options.Threads = 3;
	EXPECT_EQ(One, RunConfig(Options).RunJson);
}

TEST(RunOutputs, AreCompleteAndTheSameBytesEachTime)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	FRunOptions Options = SmallScene();
	Options.Dump = {"Bloom6Y"};
	WriteRunOutputs(RunConfig(Options), (Folder / "a").string());
	WriteRunOutputs(RunConfig(Options), (Folder / "b").string());
	for (const char* Name : {"final.png", "final.exr", "scene_linear.exr", "run.json", "graph.dot"})
	{
		EXPECT_GT(std::filesystem::file_size(Folder / "a" / Name), 100u) << Name;
		EXPECT_EQ(ReadBytes(Folder / "a" / Name), ReadBytes(Folder / "b" / Name)) << Name;
	}
	EXPECT_TRUE(std::filesystem::exists(Folder / "a" / "timing.json"));
	EXPECT_TRUE(std::filesystem::exists(Folder / "a" / "trace.json"));
	int NumDumps = 0;
	for (const auto& Entry : std::filesystem::directory_iterator(Folder / "a" / "passes"))
	{
		NumDumps += Entry.is_regular_file();
	}
	EXPECT_EQ(2, NumDumps);
	EXPECT_EQ(2, std::distance(std::filesystem::directory_iterator(Folder), {})) << "nothing is left aside";
	std::filesystem::remove_all(Folder);
}

TEST(RunOutputs, DumpsOfAnEarlierRunGo)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	FRunOptions Options = SmallScene();
	Options.Dump = {"Bloom6Y"};
	WriteRunOutputs(RunConfig(Options), Folder.string());
	EXPECT_TRUE(std::filesystem::exists(Folder / "passes"));
	std::ofstream(Folder / "note.txt") << "mine";
	WriteRunOutputs(RunConfig(SmallScene()), Folder.string());
	EXPECT_FALSE(std::filesystem::exists(Folder / "passes"));
	EXPECT_TRUE(std::filesystem::exists(Folder / "note.txt"));
	std::filesystem::remove_all(Folder);
}

TEST(RunOutputs, DefaultFolderIsNamedAfterTheConfig)
{
	EXPECT_EQ("out/toon_bloom", GetDefaultOutputFolder("configs/toon_bloom.json"));
}
