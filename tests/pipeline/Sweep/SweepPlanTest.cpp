// A config's sweep as tasks: what is combined, left out and cut into pieces, what a hash depends on, and mistakes at
// their places.
#include <gtest/gtest.h>

#include "../ProgramTestUtils.h"

#include "Sweep/SweepFolder.h"
#include "Sweep/SweepPlanner.h"
#include "TextTools.h"

#include <algorithm>
#include <set>

using namespace Drydock;
using namespace ProgramTest;

namespace
{

class FSweepConfig : public FProgramFolder
{
public:
	FSweepConfig()
		: FProgramFolder("sweep_plan")
	{
		WriteFrame("single.json", "");
		for (const char* const Frame : {"1", "2", "3", "4", "5"})
		{
			Files::copy(Path / "scene.exr", Path / (std::string("walk.") + Frame + ".exr"));
		}
	}

	FSweepPlan Plan(const std::string& Sweep, const std::string& Scene = "scene.exr")
	{
		Remarks.clear();
		Write("sweep.json", "{\"scene\": {\"file\": \"" + Scene + "\"},\n\"sweep\": " + Sweep + "}");
		const std::string File = (Path / "sweep.json").string();
		std::vector<FDiagnostic> Ignored;
		return PlanSweep(LoadConfig(File, Ignored), FindSweep(LoadConfigDocument(File)), Remarks);
	}

	/** "2:14 message" of each. */
	std::vector<std::string> FindMistakes(const std::string& Sweep, const std::string& Scene = "scene.exr")
	{
		try
		{
			Plan(Sweep, Scene);
		}
		catch (const FError& Error)
		{
			std::vector<std::string> Texts;
			for (const FDiagnostic& One : Error.GetDiagnostics())
			{
				Texts.push_back(std::to_string(One.Line) + ":" + std::to_string(One.Column) + " " + One.Message);
			}
			return Texts;
		}
		return {};
	}

	std::vector<FDiagnostic> Remarks;
};

std::vector<std::string> ListTasks(const FSweepPlan& Plan)
{
	std::vector<std::string> Texts;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		Texts.push_back(DescribeTask(Plan, Task));
	}
	return Texts;
}

} // namespace

TEST(SweepPlan, AxesAreCombinedTheLastTheFastestAndExcludeLeavesOut)
{
	FSweepConfig Config;
	const FSweepPlan Plan = Config.Plan(R"({"axes": [
		{"name": "BloomIntensity", "values": [0.5, 2]},
		{"name": "quality", "values": [{"label": "low", "set": {"r.BloomQuality": 1}}, {"label": "high", "set": {"r.BloomQuality": 5}}]}],
		"exclude": [{"BloomIntensity": 2, "quality": "low"}]})");
	EXPECT_EQ(
		(std::vector<std::string>{"BloomIntensity 0.5, low", "BloomIntensity 0.5, high", "BloomIntensity 2, high"}),
		ListTasks(Plan));
	EXPECT_EQ((FSweepSet{{"BloomIntensity", "2"}, {"r.BloomQuality", "5"}}), Plan.Tasks[2].Set);
	EXPECT_TRUE(Config.Remarks.empty());
}

TEST(SweepPlan, FramesAreCutIntoPiecesWithALeadAndTheFirstCutStaysWholeToo)
{
	FSweepConfig Config;
	const FSweepPlan Plan = Config.Plan(
		R"({"frames": "all", "split": {"frames": 2, "lead": 1}, "axes": [{"name": "BloomIntensity", "values": [1, 2]}]})",
		"walk.#.exr");
	ASSERT_EQ(7u, Plan.Tasks.size());
	EXPECT_EQ("1-2", Plan.Tasks[0].Frames);
	EXPECT_EQ("", Plan.Tasks[0].LeadFrames);
	EXPECT_EQ("3-4", Plan.Tasks[1].Frames);
	EXPECT_EQ("2", Plan.Tasks[1].LeadFrames);
	EXPECT_EQ("5", Plan.Tasks[2].Frames);
	EXPECT_TRUE(Plan.Tasks[3].bUnsplit);
	EXPECT_EQ("1-5", Plan.Tasks[3].Frames);
	EXPECT_EQ("BloomIntensity 2, piece 5", DescribeTask(Plan, Plan.Tasks[6]));
}

TEST(SweepPlan, LeadTakesTheFramesOfTheSceneBeforeTheFirst)
{
	FSweepConfig Config;
	const FSweepPlan Plan = Config.Plan(
		R"({"lead": 2, "axes": [{"name": "frames", "values": ["4-5", "1"]}, {"name": "BloomIntensity", "values": [1, 2]}]})",
		"walk.#.exr");
	EXPECT_EQ("2-3", Plan.Tasks[0].LeadFrames);
	EXPECT_EQ("", Plan.Tasks[2].LeadFrames);
}

TEST(SweepPlan, AHashDependsOnWhatTheTaskReadsAndOnNothingElse)
{
	FSweepConfig Config;
	const char* const Sweep = R"({"axes": [{"name": "frames", "values": ["1", "2"]}]})";
	const FSweepPlan Before = Config.Plan(Sweep, "walk.#.exr");
	const FSweepPlan More = Config.Plan(
		R"({"axes": [{"name": "frames", "values": ["3", "1"]}], "exclude": [{"frames": "3"}]})", "walk.#.exr");
	EXPECT_EQ(Before.Tasks[0].Hash, More.Tasks[0].Hash) << "the sweep may grow";
	Config.WriteFrame("other.json", "");
	Files::copy(DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/two_boxes.exr", Config.Path / "walk.2.exr",
		Files::copy_options::overwrite_existing);
	const FSweepPlan After = Config.Plan(Sweep, "walk.#.exr");
	EXPECT_EQ(Before.Tasks[0].Hash, After.Tasks[0].Hash);
	EXPECT_NE(Before.Tasks[1].Hash, After.Tasks[1].Hash) << "its frame has changed";
	const FSweepPlan Exr =
		Config.Plan(R"({"outputs": ["exr"], "axes": [{"name": "frames", "values": ["1", "2"]}]})", "walk.#.exr");
	EXPECT_NE(After.Tasks[0].Hash, Exr.Tasks[0].Hash);
}

TEST(SweepPlan, AllMistakesComeTogetherAtTheirPlaces)
{
	FSweepConfig Config;
	const std::vector<std::string> Names = Config.FindMistakes(R"({"lead": 1.5, "axes": [
{"name": "BloomIntensty", "values": [1]},
{"name": "BloomIntensity", "values": ["much"]},
{"name": "engine", "values": ["5.4"]}],
"exclude": [{"engin": "5.4"}, {"engine": "5.5"}]})");
	ASSERT_EQ(5u, Names.size()) << JoinText(Names, "\n");
	EXPECT_TRUE(Names[0].starts_with("2:19 \"lead\" must be a whole number")) << Names[0];
	EXPECT_TRUE(Names[1].starts_with("3:10 \"BloomIntensty\" is not a setting")) << Names[1];
	EXPECT_TRUE(Names[1].ends_with("did you mean BloomIntensity?")) << Names[1];
	EXPECT_TRUE(Names[2].starts_with("4:39 ")) << Names[2];
	EXPECT_TRUE(Names[3].starts_with("6:14 there is no axis \"engin\"")) << Names[3];
	EXPECT_TRUE(Names[4].starts_with("6:42 the axis \"engine\" has no value \"5.5\"")) << Names[4];
}

TEST(SweepPlan, ValuesAreCheckedWithTheConfigAndItsFiles)
{
	FSweepConfig Config;
	const std::vector<std::string> Files = Config.FindMistakes(R"({"axes": [
{"name": "engine", "values": ["5.4", "4.27"]},
{"name": "scene", "values": ["scene.exr", "none.exr"]},
{"name": "resolution", "values": [50, 500]}]})");
	ASSERT_EQ(3u, Files.size()) << JoinText(Files, "\n");
	EXPECT_TRUE(Files[0].starts_with("3:38 ")) << Files[0];
	EXPECT_TRUE(Files[1].starts_with("4:43 ")) << Files[1];
	EXPECT_TRUE(Files[2].starts_with("5:39 resolution must be")) << Files[2];
	const std::vector<std::string> Frames =
		Config.FindMistakes(R"({"axes": [{"name": "frames", "values": ["1", "9"]}]})", "walk.#.exr");
	ASSERT_EQ(1u, Frames.size());
	EXPECT_TRUE(Frames[0].starts_with("2:55 ")) << Frames[0];
}

TEST(SweepPlan, AnAxisOfOneValueAndAnExcludeOfNothingAreSaid)
{
	FSweepConfig Config;
	Config.Plan(R"({"axes": [{"name": "BloomIntensity", "values": [1]}, {"name": "engine", "values": ["5.4", "5.5"]}],
		"exclude": [{"engine": "5.4"}, {"BloomIntensity": 1, "engine": "5.4"}]})");
	ASSERT_EQ(2u, Config.Remarks.size());
	EXPECT_NE(std::string::npos, Config.Remarks[0].Message.find("changes nothing: it has one value"));
	EXPECT_NE(std::string::npos, Config.Remarks[1].Message.find("leaves nothing out"));
}

TEST(SweepPlan, AFolderGivesThePlanBack)
{
	FSweepConfig Config;
	FSweepPlan Plan = Config.Plan(
		R"({"frames": "1-3", "split": {"frames": 2, "lead": 1}, "outputs": ["exr"], "axes": [{"name": "BloomIntensity", "values": [1, 2]}],
		"against": {"BloomIntensity": 2}})",
		"walk.#.exr");
	Plan.SecondsPerFrame = 0.1;
	Plan.BytesPerFrame = 1234;
	const FSweepFolder Folder(Config.Path / "out");
	Folder.WritePlan(Plan);
	const FSweepPlan Read = Folder.ReadPlan();
	EXPECT_EQ(ListTasks(Plan), ListTasks(Read));
	EXPECT_EQ(Plan.Tasks[1].Hash, Read.Tasks[1].Hash);
	EXPECT_EQ(Plan.Tasks[1].LeadFrames, Read.Tasks[1].LeadFrames);
	EXPECT_EQ(Plan.Tasks[2].bUnsplit, Read.Tasks[2].bUnsplit);
	EXPECT_EQ(Plan.Against, Read.Against);
	EXPECT_EQ(Plan.Inputs, Read.Inputs);
	EXPECT_TRUE(Read.bExr);
	EXPECT_EQ(Plan.GetSeconds(), Read.GetSeconds());
	EXPECT_DOUBLE_EQ(0.1 * 11, Plan.GetSeconds()) << "2 + 2 + 3 frames and leads, and 2 + 2";
	Config.Write("out/tasks.jsonl", "{}\n");
	EXPECT_THROW(Folder.ReadPlan(), FError);
}
