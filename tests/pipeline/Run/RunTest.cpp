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

TEST(RunNonFinite, ThoseOfDepthVelocityAndMasksAreNamedAndFollowedToTheFinalPicture)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	constexpr double Infinity = std::numeric_limits<double>::infinity();
	const std::vector<std::string> Names = {"R", "G", "B", "Z", "velocity.X", "velocity.Y", "custommask.B"};
	FImage Image{96, 64, 7, {}};
	for (int Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		const double Grey = 0.1 * (Pixel % 96 / 8 % 2);
		Image.Values.insert(Image.Values.end(), {Grey, Grey, Grey, 2.0, 4.0, 0.0, 0.5});
	}
	const auto At = [&Image](int X, int Y, int Channel) -> double&
	{
		return Image.Values[static_cast<size_t>((Y * 96 + X) * 7 + Channel)];
	};
	At(90, 60, 3) = Infinity; // where nothing is
	WriteExr((Folder / "sound.exr").string(), Image, Names);
	At(30, 20, 3) = std::nan("");
	At(31, 20, 3) = -Infinity;
	At(40, 22, 5) = Infinity;
	At(50, 24, 6) = std::nan("");
	WriteExr((Folder / "nan.exr").string(), Image, Names);
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	const auto Choose = [&Options](const std::string& File)
	{
		Options.ConfigText =
			R"({"scene": {"file": ")" + File + R"(", "channels": {"depth.Z": "Z"}}, "camera": {"Settings": {
			"DepthOfFieldFocalDistance": 100, "DepthOfFieldFstop": 1, "DepthOfFieldSensorWidth": 200, "MotionBlurAmount": 0.5,
			"CharaGlowArea": 3, "CharaGlowColor": [1, 1, 1, 1]}}})";
	};
	const auto GetWarnings = [&Folder](const FRunResult& Result)
	{
		std::vector<std::string> Warnings;
		for (const FDiagnostic& Diagnostic : Result.Diagnostics)
		{
			if (Diagnostic.Severity == ESeverity::Warning && Diagnostic.Code == WarnNonFinite)
			{
				EXPECT_EQ((Folder / "nan.exr").string(), Diagnostic.File);
				Warnings.push_back(Diagnostic.Where + ": " + Diagnostic.Message);
			}
		}
		return Warnings;
	};
	Choose("sound.exr");
	EXPECT_TRUE(GetWarnings(RunConfig(Options)).empty());

	Choose("nan.exr");
	const FRunResult Result = RunConfig(Options);
	EXPECT_EQ((std::vector<std::string>{"channel Z: 2 values are NaN or infinite, first at pixel (30, 20)",
				  "channel custommask.B: 1 value is NaN or infinite, first at pixel (50, 24)",
				  "channel velocity.Y: 1 value is NaN or infinite, first at pixel (40, 22)"}),
		GetWarnings(Result));
	EXPECT_EQ(WarnNonFiniteSpread, Result.Diagnostics.back().Code);
	EXPECT_EQ("channel Z, channel custommask.B, channel velocity.Y", Result.Diagnostics.back().Where);
	ASSERT_TRUE(Result.NonFinite.Final.has_value());
	EXPECT_GT(Result.NonFinite.Final->Changed, 0u);

	Options.Variables = {"r.Drydock.NonFinite=1"}; // leaves what is infinitely far where it is
	const FRunResult Zeroed = RunConfig(Options);
	EXPECT_EQ(3u, GetWarnings(Zeroed).size());
	EXPECT_TRUE(Zeroed.NonFinite.Passes.empty());
	Options.Variables = {"r.Drydock.NonFinite=2"};
	EXPECT_EQ("4002 1", ErrorOf(Options));
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
