// `drydock sweep` as a user calls it: tasks run once and are left out when they are finished, failures leave messages,
// a crash costs one task, and every way to run a sweep gives the same bytes.
#include <gtest/gtest.h>

#include "../ProgramTestUtils.h"

#include "Sweep/SweepFolder.h"
#include "Sweep/SweepReduce.h"
#include "Sweep/SweepSubmit.h"
#include "TextTools.h"

#include <map>
#include <nlohmann/json.hpp>

using namespace Drydock;
using namespace ProgramTest;

namespace
{

class FSweepProgram : public FProgramFolder
{
public:
	explicit FSweepProgram(const std::string& Name, const std::string& Sweep = "")
		: FProgramFolder("sweep_" + Name)
	{
		WriteFrame(
			"sweep.json", ", \"volumes\": [{\"bUnbound\": true, \"Settings\": {\"BloomThreshold\": -1}}], \"sweep\": " +
							  (Sweep.empty() ? R"({"axes": [{"name": "r.BloomQuality", "values": [1, 5]},
			{"name": "BloomIntensity", "values": [0.5, 1, 2]}], "against": {"r.BloomQuality": 5}})"
											 : Sweep));
	}

	void Plan(const std::string& Folder)
	{
		const FOutcome Outcome = Call("sweep plan sweep.json --out " + Folder);
		ASSERT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	}

	/** All that must be the same bytes. */
	std::map<std::string, std::string> ReadResults(const std::string& Folder) const
	{
		std::map<std::string, std::string> Bytes;
		for (const Files::directory_entry& Entry : Files::recursive_directory_iterator(Path / Folder))
		{
			const std::string Name = Entry.path().lexically_relative(Path / Folder).generic_string();
			if (Entry.is_regular_file() &&
				(Name.starts_with("results/") || Name.starts_with("plots/") || Name.starts_with("table.") ||
					Name == "sheet.png" || Name == "tasks.jsonl"))
			{
				Bytes[Name] = Read(Folder + "/" + Name);
			}
		}
		return Bytes;
	}

	nlohmann::json Status(const std::string& Folder) const
	{
		return nlohmann::json::parse(Call("sweep status " + Folder + " --json").Printed);
	}
};

std::vector<std::string> GetHashes(const Files::path& Folder)
{
	std::vector<std::string> Hashes;
	for (const FSweepTask& Task : FSweepFolder(Folder).ReadPlan().Tasks)
	{
		Hashes.push_back(Task.Hash);
	}
	return Hashes;
}

} // namespace

TEST(SweepProgram, PlanTellsTasksTimeAndDisk)
{
	FSweepProgram Folder("plan");
	const FOutcome Outcome = Folder.Call("sweep plan sweep.json --out out");
	EXPECT_EQ(0, Outcome.ExitCode);
	EXPECT_NE(
		std::string::npos, Outcome.Printed.find("tasks    6 (r.BloomQuality 2 x BloomIntensity 3), 0 of them done"))
		<< Outcome.Printed;
	EXPECT_NE(std::string::npos, Outcome.Printed.find("in one process: a frame takes"));
	EXPECT_EQ(6, Folder.Status("out")["missing"]);
	EXPECT_FALSE(Files::exists(Folder.Path / "out/results"));
}

TEST(SweepProgram, AnyOrderAndNumberOfShardsGivesTheSameBytesAndNothingRunsTwice)
{
	FSweepProgram Folder("shards");
	Folder.Plan("one");
	Folder.Plan("many");
	const FOutcome One = Folder.Call("sweep exec one --here");
	EXPECT_EQ("6 tasks run, 0 were there, 0 failed\n", One.Printed);
	for (const char* const Shard : {"3", "1", "4", "2"})
	{
		const FOutcome Outcome = Folder.Call(std::string("sweep exec many --of 4 --threads 1 --index ") + Shard);
		EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	}
	EXPECT_EQ("0 tasks run, 6 were there, 0 failed\n", Folder.Call("sweep exec many").Printed);
	EXPECT_EQ(0, Folder.Call("sweep reduce one").ExitCode);
	EXPECT_EQ(0, Folder.Call("sweep reduce many").ExitCode);
	const auto Bytes = Folder.ReadResults("one");
	EXPECT_GT(Bytes.size(), 20u);
	EXPECT_EQ(Bytes, Folder.ReadResults("many"));
}

TEST(SweepProgram, ADamagedResultRunsAgainAndAForeignFileStays)
{
	FSweepProgram Folder("damaged");
	Folder.Plan("out");
	Folder.Call("sweep exec out --here");
	const auto Before = Folder.ReadResults("out");
	const std::string First =
		"out/results/" + GetHashes(Folder.Path / "out")[0].substr(0, 2) + "/" + GetHashes(Folder.Path / "out")[0];
	Folder.Write(First + "/final.png", "torn");
	const FOutcome Missing = Folder.Call("sweep reduce out");
	EXPECT_EQ(1, Missing.ExitCode);
	EXPECT_NE(std::string::npos, Missing.Printed.find("DD1144")) << Missing.Printed;
	EXPECT_NE(std::string::npos, Missing.Printed.find("damaged")) << Missing.Printed;
	EXPECT_EQ("1 tasks run, 5 were there, 0 failed\n", Folder.Call("sweep exec out --here").Printed);
	EXPECT_EQ(Before, Folder.ReadResults("out"));
	Folder.Write(First + "/final.png", "torn");
	Folder.Write(First + "/notes.txt", "mine");
	EXPECT_EQ(1, Folder.Call("sweep exec out").ExitCode);
	EXPECT_EQ("mine", Folder.Read(First + "/notes.txt"));
}

TEST(SweepProgram, ATaskThatFailsLeavesItsMessagesAndTheOthersGoOn)
{
	FSweepProgram Folder("fails",
		R"({"axes": [{"name": "BloomIntensity", "values": [1, 2]}, {"name": "r.Drydock.NonFinite", "values": [0, 2]}]})");
	Drydock::FImage Image{16, 8, 3, std::vector<double>(16 * 8 * 3, std::numeric_limits<double>::quiet_NaN())};
	Drydock::WriteExr((Folder.Path / "scene.exr").string(), Image, {"R", "G", "B"});
	Folder.Plan("out");
	const FOutcome Outcome = Folder.Call("sweep exec out");
	EXPECT_EQ(1, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("2 tasks run, 0 were there, 2 failed")) << Outcome.Printed;
	EXPECT_NE(std::string::npos, Outcome.Printed.find("DD4002")) << Outcome.Printed;
	const auto Status = Folder.Status("out");
	EXPECT_EQ(2, Status["failed"]);
	EXPECT_EQ(2, Status["done"]);
	EXPECT_NE(std::string::npos, Status["failures"][0].get<std::string>().find("r.Drydock.NonFinite 2: ")) << Status;
	EXPECT_EQ(1, Folder.Call("sweep submit out").ExitCode);
	Folder.WriteFrame("other.json", ""); // the scene is finite again, which is another task
	EXPECT_NE(std::string::npos, Folder.Call("sweep exec out").Printed.find("DD1142"));
}

TEST(SweepProgram, ACrashCostsOneTask)
{
	FSweepProgram Folder("crash");
	Folder.WriteFrame("sweep.json", R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libCrashPlugin.so"],
		"sweep": {"axes": [{"name": "r.MotionBlurQuality", "values": [0, 3]}, {"name": "BloomIntensity", "values": [1, 2]}]})");
	Folder.Plan("out");
	setenv("DRYDOCK_TEST_CRASH", "write at SetupView", 1);
	setenv("DRYDOCK_TEST_CRASH_IF", "r.MotionBlurQuality", 1);
	const FOutcome Outcome = Folder.Call("sweep exec out");
	unsetenv("DRYDOCK_TEST_CRASH");
	unsetenv("DRYDOCK_TEST_CRASH_IF");
	EXPECT_EQ(1, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("2 tasks run, 0 were there, 2 failed")) << Outcome.Printed;
	EXPECT_NE(std::string::npos, Outcome.Printed.find("the process that ran this task ended with exit code 71"))
		<< Outcome.Printed;
	EXPECT_NE(std::string::npos, Outcome.Printed.find("libCrashPlugin.so")) << Outcome.Printed;
	EXPECT_EQ("2 tasks run, 2 were there, 0 failed\n", Folder.Call("sweep exec out").Printed)
		<< "asked again, it runs again";
}

TEST(SweepProgram, SubmitHereEndsInTableSheetPlotsAndPage)
{
	FSweepProgram Folder("submit");
	Folder.Plan("out");
	const FOutcome Outcome = Folder.Call("sweep submit out --shards 3");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	for (const char* const Name :
		{"table.json", "table.csv", "timing.csv", "sheet.png", "sweep.html", "plots/BloomIntensity.svg", "local.sh"})
	{
		EXPECT_TRUE(Files::exists(Folder.Path / "out" / Name)) << Name;
	}
	const auto Table = nlohmann::json::parse(Folder.Read("out/table.json"));
	ASSERT_EQ(6u, Table["rows"].size());
	EXPECT_EQ(0.0, Table["rows"][3]["figures"]["error rms"]) << "it is the variant that errors are measured against";
	EXPECT_GT(Table["rows"][1]["figures"]["error rms"], 0.0);
	EXPECT_GT(Table["rows"][2]["figures"]["error rms"], Table["rows"][0]["figures"]["error rms"]);
	EXPECT_TRUE(Folder.Read("out/table.csv").starts_with("task,r.BloomQuality,BloomIntensity,error max,error rms,"));
	EXPECT_EQ(6, Folder.Status("out")["done"]);
}

TEST(SweepProgram, AnAxisThatChangesNothingIsSaid)
{
	FSweepProgram Folder("idle",
		R"({"axes": [{"name": "BloomIntensity", "values": [1, 2]}, {"name": "DepthOfFieldFstop", "values": [2, 4]}]})");
	Folder.Plan("out");
	Folder.Call("sweep exec out --here");
	const FOutcome Outcome = Folder.Call("sweep reduce out");
	EXPECT_NE(std::string::npos, Outcome.Printed.find("The axis DepthOfFieldFstop changes nothing")) << Outcome.Printed;
	EXPECT_EQ(std::string::npos, Outcome.Printed.find("The axis BloomIntensity")) << Outcome.Printed;
}

TEST(SweepProgram, PiecesWithoutHistoryAreTheSameBitsAndWithOneTheErrorIsTold)
{
	FSweepProgram Folder("pieces");
	for (int Frame = 1; Frame <= 6; ++Frame)
	{
		Drydock::FImage Image{16, 8, 3, std::vector<double>(16 * 8 * 3, 0.1 * Frame * Frame)};
		Drydock::WriteExr((Folder.Path / ("walk." + std::to_string(Frame) + ".exr")).string(), Image, {"R", "G", "B"});
	}
	const auto Run = [&](const std::string& Config, const std::string& Lead)
	{
		Folder.Write("sweep.json", R"({"scene": {"file": "walk.#.exr"}, )" + Config +
									   R"("sweep": {"frames": "all", "split": {"frames": 2, "lead": )" + Lead +
									   R"(}, "axes": [{"name": "BloomIntensity", "values": [1, 2]}]}})");
		const std::string Out = "out" + std::to_string(Config.size()) + Lead;
		Folder.Plan(Out);
		Folder.Call("sweep exec " + Out + " --here");
		return Folder.Call("sweep reduce " + Out).Printed;
	};
	EXPECT_NE(
		std::string::npos, Run("", "0").find("All 6 frames of the first cut are the same bits in pieces and unsplit."));
	const std::string Adapting = R"("view": {"exposure": "auto"}, )";
	EXPECT_NE(std::string::npos, Run(Adapting, "0").find("In pieces 4 of 6 frames of the first cut differ"))
		<< Run(Adapting, "0");
	EXPECT_NE(std::string::npos, Run(Adapting, "6").find("All 6 frames"));
}

TEST(SweepProgram, StudiesAndHazardsAreTasksToo)
{
	FSweepProgram Folder(
		"kinds", R"({"task": "hazards", "pass": "Tonemap", "axes": [{"name": "engine", "values": ["5.4", "5.6"]}]})");
	Folder.Plan("hazards");
	EXPECT_EQ(0, Folder.Call("sweep submit hazards").ExitCode);
	const auto Hazards = nlohmann::json::parse(Folder.Read("hazards/table.json"));
	EXPECT_GT(Hazards["rows"][0]["figures"]["cases"], 5.0);
	Folder.Write("sweep.json",
		R"({"scene": {"file": "scene.exr"}, "study": {"repetitions": 1, "axes": [{"name": "r.BloomQuality", "values": [1, 5]}]},
		"sweep": {"task": "study", "axes": [{"name": "BloomIntensity", "values": [1, 2]}]}})");
	Folder.Plan("study");
	EXPECT_EQ(0, Folder.Call("sweep submit study").ExitCode);
	const auto Study = nlohmann::json::parse(Folder.Read("study/table.json"));
	EXPECT_EQ(2.0, Study["rows"][1]["figures"]["variants"]);
}

TEST(SweepProgram, ALargeSweepAsksForYes)
{
	std::string Values;
	for (int Value = 1; Value <= 101; ++Value)
	{
		Values += (Values.empty() ? "" : ",") + std::to_string(Value);
	}
	FSweepProgram Folder("large", R"({"axes": [{"name": "BloomIntensity", "values": [)" + Values +
									  R"(]}, {"name": "VignetteIntensity", "values": [)" + Values + "]}]}");
	const FOutcome Outcome = Folder.Call("sweep plan sweep.json --out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("DD1140")) << Outcome.Printed;
	EXPECT_NE(std::string::npos, Outcome.Printed.find("10201 combinations: --yes goes on")) << Outcome.Printed;
	EXPECT_FALSE(Files::exists(Folder.Path / "out"));
}

TEST(SweepProgram, AFolderWithoutAPlanAndAnUnknownShardAreMistakes)
{
	FSweepProgram Folder("mistakes");
	Files::create_directories(Folder.Path / "empty");
	EXPECT_EQ(2, Folder.Call("sweep exec empty").ExitCode);
	EXPECT_NE(std::string::npos, Folder.Call("sweep status empty").Printed.find("DD1141"));
	Folder.Plan("out");
	EXPECT_NE(
		std::string::npos, Folder.Call("sweep exec out --index 3 --of 2").Printed.find("there is no shard 3 of 2"));
	EXPECT_NE(std::string::npos, Folder.Call("sweep exec out --task zz").Printed.find("no task with the hash zz"));
	EXPECT_EQ("1 tasks run, 0 were there, 0 failed\n",
		Folder.Call("sweep exec out --here --task " + GetHashes(Folder.Path / "out")[2].substr(0, 10)).Printed);
	EXPECT_NE(std::string::npos, Folder.Call("sweep plan single.json --out none").Printed.find("cannot be read"));
	Folder.WriteFrame("single.json", "");
	EXPECT_NE(std::string::npos,
		Folder.Call("sweep plan single.json --out none").Printed.find("the config has no \"sweep\""));
}

TEST(SweepSubmit, ScriptsHandPathsAndOptionsOn)
{
	const FSubmitRequest Request{
		.Folder = "/data/my sweep", .Engine = "parallel", .NumShards = 7, .Options = {"--sshlogin", "a,b"}};
	const std::string Parallel = MakeSubmitScripts(Request, "/opt/drydock", "/data/my sweep/p.joblog")[0].second;
	EXPECT_NE(std::string::npos, Parallel.find("seq 1 7 | exec parallel")) << Parallel;
	EXPECT_NE(std::string::npos,
		Parallel.find("--joblog '/data/my sweep/p.joblog' --resume --resume-failed --sshlogin 'a,b' "))
		<< Parallel;
	FSubmitRequest Slurm = Request;
	Slurm.Engine = "slurm";
	Slurm.Options = {"--partition=long"};
	const auto Scripts = MakeSubmitScripts(Slurm, "/opt/drydock", "");
	ASSERT_EQ(3u, Scripts.size());
	EXPECT_NE(std::string::npos, Scripts[0].second.find("sbatch --parsable --dependency=afterany:"))
		<< Scripts[0].second;
	EXPECT_NE(std::string::npos, Scripts[1].second.find("#SBATCH --array=1-7\n")) << Scripts[1].second;
}

TEST(SweepSubmit, AJoblogThatLeavesResultsOutIsStale)
{
	FSweepProgram Folder("joblog");
	Folder.Plan("out");
	const FSweepFolder Sweep(Folder.Path / "out");
	const FSweepPlan Plan = Sweep.ReadPlan();
	const std::string Head = "Seq\tHost\tStarttime\tJobRuntime\tSend\tReceive\tExitval\tSignal\tCommand\n";
	const std::string Done = Head + "1\t:\t1.0\t1.0\t0\t0\t0\t0\tdrydock\n";
	EXPECT_TRUE(IsJoblogStale(Done, Sweep, Plan, 2));
	EXPECT_FALSE(IsJoblogStale(Head + "1\t:\t1.0\t1.0\t0\t0\t1\t0\tdrydock\n", Sweep, Plan, 2))
		<< "it is run again anyhow";
	Folder.Call("sweep exec out --here --index 1 --of 2");
	EXPECT_FALSE(IsJoblogStale(Done, Sweep, Plan, 2));
}
