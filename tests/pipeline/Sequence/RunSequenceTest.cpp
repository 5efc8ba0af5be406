// Sequences in this process: what is written, what lives on, and when a folder is taken up again. A little past 500
// lines: the cases share one sequence and its helpers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Run/Run.h"
#include "SceneViewExtension.h"
#include "Sequence/RunSequence.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/SequenceFolder.h"
#include "Sequence/SequenceSheet.h"
#include "SequenceTestUtils.h"
#include "Text/FileList.h"
#include "Text/Json.h"

using namespace Drydock;
using namespace SequenceTest;
using testing::HasSubstr;

namespace
{

const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";

/** Notes what time each frame has. */
class FTimeWatch final : public FSceneViewExtensionBase
{
public:
	explicit FTimeWatch(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	void SetupViewFamily(FSceneViewFamily& Family) override { Times.push_back(Family.Time); }

	std::vector<FGameTime> Times;
};

double GetGreatest(const FImage& Image, size_t Channel)
{
	double Greatest = -1.0;
	for (size_t Index = Channel; Index < Image.Values.size(); Index += static_cast<size_t>(Image.NumChannels))
	{
		Greatest = std::max(Greatest, Image.Values[Index]);
	}
	return Greatest;
}

class RunSequences : public testing::Test
{
protected:
	FSequenceOptions Ask(const std::string& Frames, const std::string& Out = "out", const std::string& More = "") const
	{
		FSequenceOptions Options;
		Options.Run.ConfigFile = (Temporary.Path / "a.json").string();
		Options.Run.ConfigText = MakeConfigText(Scenes, More);
		Options.Frames = Frames;
		Options.Folder = (Temporary.Path / Out).string();
		return Options;
	}

	static std::string ErrorOf(const FSequenceOptions& Options)
	{
		try
		{
			RunSequence(Options);
		}
		catch (const FError& Error)
		{
			return std::to_string(Error.GetDiagnostics().at(0).Code) + " " + std::to_string(Error.GetExitCode()) + " " +
				   Error.GetDiagnostics().at(0).Message;
		}
		return "none";
	}

	/** Runs; the warnings that say which frames are rendered again, without their places. */
	static std::vector<std::string> RunAgain(FSequenceOptions Options)
	{
		std::vector<std::string> Messages;
		Options.Report = [&](const std::vector<FDiagnostic>& Diagnostics)
		{
			for (const FDiagnostic& Diagnostic : Diagnostics)
			{
				if (Diagnostic.Code == WarnFrameDamaged)
				{
					Messages.push_back(Diagnostic.Message);
				}
			}
		};
		RunSequence(Options);
		return Messages;
	}

	static FJsonValue Parse(const std::string& Text)
	{
		std::vector<FDiagnostic> Diagnostics;
		bool bSyntaxError = false;
		FJsonValue Value = ParseJson(Text, "sequence.json", Diagnostics, bSyntaxError);
		EXPECT_TRUE(Diagnostics.empty());
		return Value;
	}

	const FTemporaryFolder Temporary{"drydock_sequence"};
};

} // namespace

TEST_F(RunSequences, WriteEachFrameAsARunDoes)
{
	const FSequenceResult Result = RunSequence(Ask("3-5x2"));
	EXPECT_EQ((std::vector<int>{3, 5}), Result.Frames);
	EXPECT_EQ(2, Result.NumRendered);
	for (const char* Name : {"final.png", "final.exr", "scene_linear.exr", "run.json", "timing.json", "graph.dot",
			 "trace.json", "frame.json"})
	{
		EXPECT_TRUE(Files::exists(Temporary.Path / "out/frames/0005" / Name)) << Name;
	}
	EXPECT_TRUE(Files::exists(Temporary.Path / "out/sequence.json"));
}

TEST_F(RunSequences, OnlyTheLatestFrameKeepsItsState)
{
	RunSequence(Ask("3-4"));
	EXPECT_FALSE(Files::exists(Temporary.Path / "out/frames/0003/view_state.bin"));
	EXPECT_TRUE(Files::exists(Temporary.Path / "out/frames/0004/view_state.bin"));
}

TEST_F(RunSequences, FrameSeesWhatTheOneBeforeKept)
{
	FRunSession Session(Ask("2").Run);
	const FRunResult First = Session.Run(2, {});
	EXPECT_EQ(0.0, GetGreatest(First.SceneLinear.ToImage(), 1)); // it shows the frame before, and there is none
	EXPECT_LT(0.0, GetGreatest(Session.Run(3, First.ViewStates).SceneLinear.ToImage(), 1));
	EXPECT_EQ(0.0, GetGreatest(Session.Run(3, {}).SceneLinear.ToImage(), 1));
}

TEST_F(RunSequences, FirstFrameIsThatOfASingleRun)
{
	const FSequenceOptions Options = Ask("4");
	FRunOptions Run = Options.Run;
	Run.Frame = 4;
	RunSequence(Options);
	EXPECT_EQ(RunConfig(Run).RunJson, ReadBytes(Temporary.Path / "out/frames/0004/run.json"));
}

TEST_F(RunSequences, WeightsAreThoseThatTheSceneStates)
{
	const FJsonValue Root =
		Parse(RunSequence(Ask("1-8", "out", R"(, "camera": {"Settings": {"BloomIntensity": 0}})")).SequenceJson);
	ASSERT_EQ(8u, Root.Find("frames")->Elements.size());
	for (int Frame = 1; Frame <= 8; ++Frame)
	{
		const FJsonValue Scene = Parse(ReadBytes(Scenes + "moving_camera.000" + std::to_string(Frame) + ".json"));
		const FJsonValue& Ours = Root.Find("frames")->Elements[static_cast<size_t>(Frame - 1)];
		for (const FJsonValue& Volume : Scene.Find("post_process_volumes")->Elements)
		{
			const FJsonValue* Weight = Ours.Find("volumes")->Find(Volume.Find("name")->String);
			ASSERT_NE(nullptr, Weight);
			EXPECT_NEAR(Volume.Find("camera_weight")->Number, Weight->Number, 2e-6) << Frame;
		}
		for (size_t Axis = 0; Axis < 3; ++Axis)
		{
			EXPECT_EQ(Scene.Find("position_uecm")->Elements[Axis].Number, Ours.Find("location")->Elements[Axis].Number);
		}
	}
}

TEST_F(RunSequences, SettingsThatVaryAreTold)
{
	// Frame 1 is in the warm room and 135 cm from the cold one, frame 8 in that and 105 cm from the warm one; both fade
	// over 100.
	const FJsonValue Root = Parse(RunSequence(Ask("1,8")).SequenceJson);
	const std::vector<FJsonValue>& Frames = Root.Find("frames")->Elements;
	EXPECT_NEAR(0.675, Frames[0].Find("settings")->Find("BloomIntensity")->Number, 1e-6);
	EXPECT_NEAR(2.5, Frames[1].Find("settings")->Find("BloomIntensity")->Number, 1e-6);
	EXPECT_EQ(nullptr, Frames[0].Find("settings")->Find("FilmSlope"));
}

TEST_F(RunSequences, StoppedOneGoesOnBitForBit)
{
	RunSequence(Ask("1-4", "whole"));
	RunSequence(Ask("1-2", "parts"));
	const FSequenceResult Rest = RunSequence(Ask("1-4", "parts"));
	EXPECT_EQ(2, Rest.NumRendered);
	EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / "parts"));
}

TEST_F(RunSequences, OneKilledBehindItsLastFileHasTheListOfAWholeOne)
{
	// As Put leaves it when it is killed after the rename: the old and the new sequence.json are both on the list.
	RunSequence(Ask("2-3"));
	const Files::path ListFile = Temporary.Path / "out/.drydock.sequence.files";
	const std::string Whole = ReadBytes(ListFile);
	FFileList Both = FFileList::Read(ListFile);
	Both.Add("sequence.json", std::string(32, '0'));
	std::ofstream(ListFile, std::ios::binary) << Both.GetText();
	ASSERT_NE(Whole, ReadBytes(ListFile));
	EXPECT_EQ(0, RunSequence(Ask("2-3")).NumRendered);
	EXPECT_EQ(Whole, ReadBytes(ListFile));
}

TEST_F(RunSequences, PartSaysThatItLacksHistoryAndLeadsIn)
{
	RunSequence(Ask("all", "whole"));
	const auto RunPart = [&](const std::string& Out, int Lead)
	{
		FSequenceOptions Options = Ask("5-6", Out);
		Options.Lead = Lead;
		std::string Notes;
		Options.Report = [&Notes](const std::vector<FDiagnostic>& Diagnostics)
		{
			for (const FDiagnostic& Each : Diagnostics)
			{
				Notes += Each.Code == NoteNoHistory ? Each.Message + "\n" : "";
			}
		};
		RunSequence(Options);
		EXPECT_FALSE(Files::exists(Options.Folder + "/frames/0004"));
		return Notes;
	};
	const auto IsWhole = [&](const std::string& Out)
	{
		const std::string Picture = "/frames/0005/final.exr";
		return ReadBytes(Temporary.Path / ("whole" + Picture)) == ReadBytes(Temporary.Path / (Out + Picture));
	};
	EXPECT_THAT(RunPart("none", 0),
		testing::AllOf(HasSubstr("frame 5 begins with the history of no frame, and 4 are before it"),
			HasSubstr("CustomSSRInput"), HasSubstr("--lead 4 avoids this")));
	EXPECT_FALSE(IsWhole("none"));
	EXPECT_THAT(RunPart("one", 1), HasSubstr("frame 5 begins with the history of 1 frame, and 4 are before it"));
	EXPECT_TRUE(IsWhole("one")); // each frame shows the one before it, and no other
	EXPECT_EQ("", RunPart("four", 4));
	EXPECT_TRUE(IsWhole("four"));
	EXPECT_EQ("", RunPart("many", 100));

	// Stopped behind the first frame it goes on; the frames that lead in are part of what it is made of.
	FSequenceOptions Stopped = Ask("5-5", "stopped");
	Stopped.Lead = 4;
	RunSequence(Stopped);
	Stopped.Frames = "5-6";
	RunSequence(Stopped);
	EXPECT_TRUE(AreSameFolders(Temporary.Path / "four", Temporary.Path / "stopped"));
	Stopped.Lead = 3;
	EXPECT_THAT(ErrorOf(Stopped), HasSubstr("1070 2"));
}

TEST_F(RunSequences, AutomaticExposureNeedsAllFramesBefore)
{
	const auto Run = [&](const std::string& Frames, int Lead, const std::string& Out)
	{
		FSequenceOptions Options = Ask(Frames, Out);
		Options.Run.ConfigText =
			R"({"scene": {"file": ")" + Scenes + R"(moving_camera.####.exr"}, "view": {"exposure": "auto"}})";
		Options.Lead = Lead;
		RunSequence(Options);
		return ReadBytes(Temporary.Path / Out / "frames/0005/final.exr");
	};
	const std::string Whole = Run("1-5", 0, "whole");
	for (const int Lead : {0, 1, 2, 3})
	{
		EXPECT_NE(Whole, Run("5-5", Lead, "lead" + std::to_string(Lead))) << Lead;
	}
	EXPECT_EQ(Whole, Run("5-5", 4, "lead4"));
}

TEST_F(RunSequences, FirstOfAllLacksNothing)
{
	FSequenceOptions Options = Ask("1-2");
	Options.Report = [](const std::vector<FDiagnostic>& Diagnostics)
	{
		EXPECT_TRUE(std::none_of(Diagnostics.begin(), Diagnostics.end(),
			[](const FDiagnostic& Each) { return Each.Code == NoteNoHistory; }));
	};
	RunSequence(Options);
}

TEST_F(RunSequences, FinishedOneIsLeftAsItIs)
{
	RunSequence(Ask("2-3"));
	const auto Before = Files::last_write_time(Temporary.Path / "out/frames/0003/final.png");
	EXPECT_EQ(0, RunSequence(Ask("2-3")).NumRendered);
	EXPECT_EQ(Before, Files::last_write_time(Temporary.Path / "out/frames/0003/final.png"));
}

TEST_F(RunSequences, OtherInputsAreRefusedAndNamed)
{
	RunSequence(Ask("2"));
	const std::string Begin = "1070 2 the folder holds frames of another sequence: ";
	const std::string End = "; --restart renders all frames again, --out writes to another folder";
	EXPECT_EQ(Begin + "the config has changed" + End, ErrorOf(Ask("2", "out", R"(, "cvars": {"r.BloomQuality": 3})")));
	FSequenceOptions Set = Ask("2");
	Set.Run.Variables = {"r.BloomQuality=3"};
	EXPECT_EQ(Begin + "the options were none and are --set r.BloomQuality=3" + End, ErrorOf(Set));
	EXPECT_EQ(Begin + "frame 2 exists, but the requested frames begin differently" + End, ErrorOf(Ask("1-2")));
}

TEST_F(RunSequences, ThreadsAreNoOtherInput)
{
	RunSequence(Ask("2"));
	FSequenceOptions Options = Ask("2-3");
	Options.Run.Threads = 1;
	EXPECT_EQ(1, RunSequence(Options).NumRendered);
}

TEST_F(RunSequences, RestartRendersAgain)
{
	RunSequence(Ask("2"));
	FSequenceOptions Options = Ask("1", "out", R"(, "cvars": {"r.BloomQuality": 3})");
	Options.bRestart = true;
	EXPECT_EQ(1, RunSequence(Options).NumRendered);
	EXPECT_FALSE(Files::exists(Temporary.Path / "out/frames/0002"));
}

TEST_F(RunSequences, DamagedStateIsNotGoneOnFrom)
{
	RunSequence(Ask("2"));
	const Files::path State = Temporary.Path / "out/frames/0002/view_state.bin";
	Files::resize_file(State, Files::file_size(State) - 1);
	EXPECT_EQ("5020 3 the state of a frame is damaged", ErrorOf(Ask("2-3")));
}

TEST_F(RunSequences, MistakesAreFoundBeforeAnythingIsWritten)
{
	EXPECT_EQ(
		"1020 2 \"x\" is not a frame or a range of frames: expected all, 1-8, 1-9x2 or 1,3,5-8", ErrorOf(Ask("x")));
	EXPECT_EQ(
		"5001 3 there is no frame 9 of " + Scenes + "moving_camera.####.exr: there are 1 to 8", ErrorOf(Ask("8-9")));
	FSequenceOptions Options = Ask("1");
	Options.Run.ConfigText = R"({"scene": {"file": ")" + Scenes + R"(two_boxes.exr"}})";
	EXPECT_EQ("1020 2 the scene is not a sequence: scene.file has no #### in its name", ErrorOf(Options));
	EXPECT_FALSE(Files::exists(Temporary.Path / "out"));
}

TEST_F(RunSequences, SheetShowsThemSideBySide)
{
	RunSequence(Ask("2-3"));
	const FImageFile Sheet((Temporary.Path / "out/sheet.png").string());
	EXPECT_GT(Sheet.GetWidth(), 2 * 320); // a tile is as wide as a frame
	EXPECT_LT(Sheet.GetHeight(), 2 * 180);
}

TEST(SequenceSheet, ManyFramesAreThinnedOutEvenly)
{
	EXPECT_EQ((std::vector<size_t>{0, 1, 2}), ChooseSheetFrames(3, 3));
	EXPECT_EQ((std::vector<size_t>{0, 50, 100}), ChooseSheetFrames(101, 3));
	EXPECT_EQ((std::vector<size_t>{0, 3}), ChooseSheetFrames(4, 2));
}

TEST_F(RunSequences, OneRunWritesAtATime)
{
	const FSequenceFolder Folder((Temporary.Path / "out").string(), 4);
	EXPECT_EQ("5021 3 process " + std::to_string(getpid()) +
				  " is writing to this folder: wait for it, or name another with --out",
		ErrorOf(Ask("2")));
}

TEST_F(RunSequences, TimeIsThatOfTheScene)
{
	const auto Watch = FSceneViewExtensions::NewExtension<FTimeWatch>();
	FRunSession Session(Ask("2").Run);
	const FRunResult First = Session.Run(2, {});
	Session.Run(5, First.ViewStates);
	// The frames' headers say 24 frames a second.
	EXPECT_FLOAT_EQ(2.0f / 24.0f, Watch->Times.at(0).WorldTimeSeconds);
	EXPECT_FLOAT_EQ(1.0f / 24.0f, Watch->Times.at(0).DeltaWorldTimeSeconds);
	EXPECT_FLOAT_EQ(5.0f / 24.0f, Watch->Times.at(1).WorldTimeSeconds);
	EXPECT_FLOAT_EQ(3.0f / 24.0f, Watch->Times.at(1).DeltaWorldTimeSeconds);
}

TEST_F(RunSequences, ConfigsRateBeatsTheScenes)
{
	const auto Watch = FSceneViewExtensions::NewExtension<FTimeWatch>();
	FSequenceOptions Options = Ask("1");
	Options.Run.ConfigText = R"({"scene": {"fps": 50, "file": ")" + Scenes + R"(moving_camera.####.exr"}})";
	EXPECT_EQ(50.0, RunSequence(Options).FramesPerSecond);
	EXPECT_FLOAT_EQ(0.02f, Watch->Times.at(0).DeltaWorldTimeSeconds);
}

TEST_F(RunSequences, FrameThatIsNotAsItWasWrittenIsRenderedAgain)
{
	using FMessages = std::vector<std::string>;
	RunSequence(Ask("1-4", "whole"));
	RunSequence(Ask("1-4"));
	const Files::path Frames = Temporary.Path / "out/frames";
	const auto ExpectAgain = [&](const FMessages& Messages)
	{
		EXPECT_EQ(Messages, RunAgain(Ask("1-4")));
		EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / "out"));
	};
	Files::remove(Frames / "0002/final.png");
	ExpectAgain({"frame 2 is rendered again: its final.png is missing"});
	Files::resize_file(Frames / "0001/final.exr", 0);
	ExpectAgain({"frame 1 is rendered again: its final.exr is empty"});
	std::string Bytes = ReadBytes(Frames / "0004/scene_linear.exr");
	Bytes[Bytes.size() / 2] = static_cast<char>(Bytes[Bytes.size() / 2] ^ 1);
	std::ofstream(Frames / "0004/scene_linear.exr", std::ios::binary) << Bytes;
	ExpectAgain({"frame 4 is rendered again: its scene_linear.exr is not as it was written"});
	Files::resize_file(Frames / "0003/frame.json", Files::file_size(Frames / "0003/frame.json") / 2);
	Files::remove_all(Frames / "0001");
	ExpectAgain({"frame 3 is rendered again: its frame.json is not as it was written",
		"frame 1 is rendered again: it is missing"});
	Files::remove(Temporary.Path / "out/sheet.png");
	ExpectAgain({});
}

TEST_F(RunSequences, LaterFrameIsRenderedAgainWhereItsHistoryIsAnother)
{
	// Frame 3 of another camera: what frame 4 saw of it is no more.
	const auto Copy = [&](int Frame, int From)
	{
		const std::string Number = std::to_string(From);
		Files::copy_file(Scenes + "moving_camera.000" + Number + ".exr",
			Temporary.Path / ("f." + std::to_string(Frame) + ".exr"), Files::copy_options::overwrite_existing);
	};
	const auto AskFor = [&](const std::string& Out)
	{
		FSequenceOptions Options = Ask("1-3", Out);
		Options.Run.ConfigText = R"({"scene": {"file": "f.#.exr"}})";
		return Options;
	};
	Copy(1, 1);
	Copy(2, 2);
	Copy(3, 3);
	RunSequence(AskFor("out"));
	Copy(2, 8);
	Files::remove_all(Temporary.Path / "out/frames/2");
	EXPECT_EQ((std::vector<std::string>{"frame 2 is rendered again: it is missing",
				  "frame 3 is rendered again: the frame before it has changed"}),
		RunAgain(AskFor("out")));
	RunSequence(AskFor("whole"));
	EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / "out"));
}

TEST_F(RunSequences, OnlyItsOwnFilesAreRemoved)
{
	const Files::path Out = Temporary.Path / "out";
	RunSequence(Ask("2"));
	std::ofstream(Out / "frames/0002/note.txt") << "mine";
	FSequenceOptions Restart = Ask("1");
	Restart.bRestart = true;
	EXPECT_EQ(0u, ErrorOf(Restart).find("1080 2 drydock did not write this")) << ErrorOf(Restart);
	EXPECT_EQ("mine", ReadBytes(Out / "frames/0002/note.txt"));
	EXPECT_TRUE(Files::exists(Out / "frames/0002/final.png"));
	Files::rename(Out / "frames/0002/note.txt", Out / "frames/note.txt");
	std::ofstream(Out / "frames/0002.writing.notes") << "mine";
	std::ofstream(Out / "story.writing.2.txt") << "mine";
	RunSequence(Restart);
	EXPECT_FALSE(Files::exists(Out / "frames/0002"));
	EXPECT_EQ("mine", ReadBytes(Out / "frames/note.txt"));
	EXPECT_EQ("mine", ReadBytes(Out / "frames/0002.writing.notes"));
	EXPECT_EQ("mine", ReadBytes(Out / "story.writing.2.txt"));
}

TEST_F(RunSequences, ForeignContentInTheWayIsRefusedBeforeAnythingIsWritten)
{
	for (const char* Name : {"frames/0002/picture.png", "sequence.json", "sheet.png", "frames"})
	{
		const Files::path Out = Temporary.Path / ("out" + Files::path(Name).filename().string());
		const Files::path File = Out / Name;
		const FSequenceOptions Options = Ask("2", Out.filename().string());
		Files::create_directories(File.parent_path());
		std::ofstream(File) << "mine";
		EXPECT_EQ(0u, ErrorOf(Options).find("1080 2 drydock did not write this")) << Name << ErrorOf(Options);
		EXPECT_EQ("mine", ReadBytes(File));
		EXPECT_EQ(1u, ReadFolder(Out).size());
	}
}

TEST_F(RunSequences, FrameBehindALinkIsNotItsOwn)
{
	const Files::path Out = Temporary.Path / "out";
	RunSequence(Ask("2"));
	Files::rename(Out / "frames/0002", Temporary.Path / "elsewhere");
	Files::create_directory_symlink(Temporary.Path / "elsewhere", Out / "frames/0002");
	FSequenceOptions Restart = Ask("2");
	Restart.bRestart = true;
	EXPECT_EQ(0u, ErrorOf(Restart).find("1080 2 drydock did not write this")) << ErrorOf(Restart);
	EXPECT_TRUE(Files::exists(Temporary.Path / "elsewhere/final.png"));
}

TEST_F(RunSequences, DamagedSequenceJsonIsRefusedAndRestartMendsIt)
{
	RunSequence(Ask("2"));
	const Files::path File = Temporary.Path / "out/sequence.json";
	std::string Bytes = ReadBytes(File);
	Bytes.replace(Bytes.find("\"varying\""), 9, "\"wandering\"");
	std::ofstream(File, std::ios::binary) << Bytes;
	EXPECT_EQ("5022 3 this is not as it was written: --restart renders all frames again", ErrorOf(Ask("2")));
	FSequenceOptions Restart = Ask("2");
	Restart.bRestart = true;
	EXPECT_EQ(1, RunSequence(Restart).NumRendered);
}

TEST_F(RunSequences, StateOfAnotherFrameIsNotGoneOnFrom)
{
	RunSequence(Ask("1", "other"));
	RunSequence(Ask("2"));
	Files::copy_file(Temporary.Path / "other/frames/0001/view_state.bin",
		Temporary.Path / "out/frames/0002/view_state.bin", Files::copy_options::overwrite_existing);
	EXPECT_EQ("5020 3 the state belongs to another frame", ErrorOf(Ask("2-3")));
}

TEST_F(RunSequences, LostStateIsComputedAgain)
{
	RunSequence(Ask("2-4", "whole"));
	RunSequence(Ask("2-3"));
	Files::remove(Temporary.Path / "out/frames/0003/view_state.bin");
	const FSequenceResult Result = RunSequence(Ask("2-4"));
	EXPECT_EQ(1, Result.NumRendered);
	EXPECT_EQ(2, Result.NumRepeated);
	EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / "out"));
}
