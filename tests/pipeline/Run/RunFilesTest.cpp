// Runs in this process: what they dump, report and write.
#include "RunTestScene.h"

using namespace Drydock;
using namespace RunTest;

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
	EXPECT_NE(std::string::npos, Result.Diagnostics[1].Message.find("matches only culled passes"));
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
