// `drydock sweep plan`, `exec`, `submit`, `status` and `reduce`: thousands of frames and configurations as tasks, run
// shard by shard, here or by a scheduler.
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepExec.h"
#include "Sweep/SweepPlanner.h"
#include "Sweep/SweepReduce.h"
#include "Sweep/SweepRun.h"
#include "Sweep/SweepSubmit.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>

namespace Drydock
{

namespace
{

struct FSweepOptions
{
	std::string Config;
	std::string Folder;
	FShardRequest Shard;
	FSubmitRequest Submit;
	std::string Report; // "on", "off"; empty: on where a person looks on
	bool bYes = false;
	bool bHere = false;
	bool bFollow = false;
	bool bJson = false;
};

std::string DescribeDuration(double Seconds)
{
	const long Whole = std::lround(std::min(Seconds, 1e12));
	return Whole >= 172'800 ? fmt::format("{} d {} h", Whole / 86'400, Whole % 86'400 / 3600)
		   : Whole >= 3600  ? fmt::format("{} h {} min", Whole / 3600, Whole % 3600 / 60)
		   : Whole >= 60    ? fmt::format("{} min {} s", Whole / 60, Whole % 60)
							: fmt::format("{:.2g} s", Seconds);
}

std::string DescribeBytes(uint64_t Bytes)
{
	return Bytes >= 1'000'000'000 ? fmt::format("{:.1f} GB", double(Bytes) / 1e9)
								  : fmt::format("{:.3g} MB", double(Bytes) / 1e6);
}

/** Calls Work on a thread of its own, and shows meanwhile how many results are there. */
template<typename TWork>
auto CallWithSweepBar(const std::string& Path, const TWork& Work)
{
	const FSweepFolder Folder(Path);
	const FSweepPlan Plan = Folder.ReadPlan();
	FProgressBar Bar;
	auto Done = std::async(std::launch::async, Work);
	while (Done.wait_for(std::chrono::milliseconds(300)) != std::future_status::ready)
	{
		const size_t NumDone = Folder.CountDone(Plan);
		Bar.Show(int(NumDone), int(Plan.Tasks.size()), "tasks");
	}
	return Done.get();
}

/** Asks for --yes. */
void RequireYes(const FSweepOptions& Options, bool bLarge, const std::string& Why)
{
	if (bLarge && !Options.bYes)
	{
		throw FError({.Code = ErrorSweepLarge, .Message = Why + ": --yes goes on", .File = Options.Config}, ExitUsage);
	}
}

int PlanTasks(const FSweepOptions& Options)
{
	constexpr size_t MostTasks = 10'000;
	FConfig Config;
	{
		FRunOptions Run;
		Run.ConfigFile = Options.Config;
		const FRunSetup Setup(Run); // its plugins, which bring settings and variables, stay loaded
		Config = Setup.Config;
	}
	const FJsonValue Sweep = FindSweep(LoadConfigDocument(Options.Config));
	const size_t NumCombinations = CountCombinations(Sweep);
	RequireYes(Options, NumCombinations > MostTasks, fmt::format("the axes have {} combinations", NumCombinations));
	std::vector<FDiagnostic> Remarks;
	FSweepPlan Plan = PlanSweep(Config, Sweep, Remarks);
	PrintDiagnostics(Remarks);
	RequireYes(Options, Plan.Tasks.size() > MostTasks, fmt::format("the sweep has {} tasks", Plan.Tasks.size()));
	const FSweepFolder Folder(Options.Folder);
	MeasureSweep(Folder.GetPath(), Plan);
	const uint64_t Free =
		std::filesystem::space(Folder.GetPath().parent_path().empty() ? "." : Folder.GetPath().parent_path()).available;
	RequireYes(Options, Plan.GetBytes() > Free,
		"the results take " + DescribeBytes(Plan.GetBytes()) + ", and " + DescribeBytes(Free) + " are free");
	Folder.WritePlan(Plan);
	FJsonWriter Writer('{');
	Writer.Members({{"tasks", uint64_t(Plan.Tasks.size())}, {"done", uint64_t(Folder.CountDone(Plan))},
		{"seconds", Plan.GetSeconds()}, {"bytes", Plan.GetBytes()}, {"freeBytes", Free}});
	const std::string Axes = JoinText(
		Plan.Axes, " x ", [](const FSweepAxis& Axis) { return Axis.Name + " " + std::to_string(Axis.Values.size()); });
	PrintResult(Options.bJson
					? Writer.GetText()
					: fmt::format("tasks    {} ({}), {} of them done\ntime     {} in one process: a {} takes {}\n"
								  "disk     {}, {} are free\nfolder   {}\n",
						  Plan.Tasks.size(), Axes, Folder.CountDone(Plan), DescribeDuration(Plan.GetSeconds()),
						  Plan.Kind == "run" ? "frame" : "task", DescribeDuration(Plan.SecondsPerFrame),
						  DescribeBytes(Plan.GetBytes()), DescribeBytes(Free), Options.Folder),
		Options.bJson);
	return ExitDone;
}

int ExecShard(const FSweepOptions& Options)
{
	FShardRequest Request = Options.Shard;
	Request.Folder = Options.Folder;
	const FShardResult Result =
		Options.bHere ? RunShard(Request) : CallWithSweepBar(Request.Folder, [&] { return RunShardApart(Request); });
	for (const std::string& Failure : Result.Failures)
	{
		PrintDiagnostics({{.Code = ErrorSweepCrash, .Message = "a task failed: " + Failure, .File = Options.Folder}});
	}
	PrintResult(fmt::format(
		"{} tasks run, {} were there, {} failed\n", Result.NumDone, Result.NumThere, Result.Failures.size()));
	return Result.Failures.empty() ? ExitDone : ExitPolicy;
}

std::string MakeStatusJson(const FSweepStatus& Status)
{
	FJsonWriter Writer('{');
	Writer.Members({{"tasks", uint64_t(Status.NumTasks)}, {"done", uint64_t(Status.NumDone)},
		{"running", uint64_t(Status.NumRunning)}, {"failed", uint64_t(Status.NumFailed)},
		{"missing", uint64_t(Status.NumMissing)}, {"secondsPerTask", Status.SecondsPerTask},
		{"secondsLeft", Status.SecondsLeft}, {"failures", Status.Failures}});
	return Writer.GetText();
}

std::string MakeStatusText(const FSweepStatus& Status, int Width)
{
	constexpr size_t BarWidth = 40, MostFailures = 20;
	FTextTable Table{{{ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Number}}, {}};
	for (const auto& [Name, Count] : {std::pair("done", Status.NumDone), {"running", Status.NumRunning},
			 {"failed", Status.NumFailed}, {"missing", Status.NumMissing}, {"all", Status.NumTasks}})
	{
		Table.Rows.push_back(
			{Name, std::to_string(Count), fmt::format("{:.1f} %", 100.0 * double(Count) / double(Status.NumTasks))});
	}
	const size_t Filled = Status.NumDone * BarWidth / Status.NumTasks;
	std::string Text = Width > 0 ? "[" + std::string(Filled, '#') + std::string(BarWidth - Filled, '.') + "]\n" : "";
	Text += Table.Format(Width) + "a task takes " + DescribeDuration(Status.SecondsPerTask) +
			(Status.SecondsLeft         ? ", " + DescribeDuration(*Status.SecondsLeft) + " left"
				: Status.NumMissing > 0 ? "; none runs"
										: "") +
			"\n";
	for (size_t Index = 0; Index < std::min(MostFailures, Status.Failures.size()); ++Index)
	{
		Text += "failed " + Status.Failures[Index] + "\n";
	}
	return Text;
}

int ShowStatus(const FSweepOptions& Options)
{
	const FSweepFolder Folder(Options.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	const auto Wait = [&]
	{
		for (FSweepStatus Now; Now = Folder.FindStatus(Plan), Now.NumRunning + Now.NumMissing > 0;)
		{
			std::this_thread::sleep_for(std::chrono::seconds(1));
		}
		return true;
	};
	Options.bFollow&& CallWithSweepBar(Options.Folder, Wait);
	const FSweepStatus Status = Folder.FindStatus(Plan);
	PrintResult(Options.bJson ? MakeStatusJson(Status) : MakeStatusText(Status, GetOutputWidth()), Options.bJson);
	return Status.NumFailed > 0 ? ExitPolicy : ExitDone;
}

int ReduceResults(const FSweepOptions& Options)
{
	const bool bPage = WantsReport(Options.Report, false);
	const std::filesystem::path Folder = Options.Folder;
	const std::vector<std::string> Notes = ReduceSweep(FSweepFolder(Folder), bPage);
	PrintResult(JoinText(Notes, "", [](const std::string& Note) { return Note + "\n"; }) + "table    " +
				(Folder / "table.csv").string() + "\n");
	if (bPage)
	{
		PrintPage(Folder / "sweep.html");
	}
	return ExitDone;
}

int Submit(const FSweepOptions& Options)
{
	FSubmitRequest Request = Options.Submit;
	Request.Folder = Options.Folder;
	const std::string Said = CallWithSweepBar(Request.Folder, [&] { return SubmitSweep(Request); });
	if (Request.Engine == "slurm")
	{
		PrintResult(Said);
		return ExitDone;
	}
	const FSweepFolder Folder(Options.Folder);
	const FSweepStatus Status = Folder.FindStatus(Folder.ReadPlan());
	if (Status.NumDone < Status.NumTasks)
	{
		PrintResult(MakeStatusText(Status, GetOutputWidth()) + Said);
		return ExitPolicy;
	}
	return ReduceResults(Options);
}

std::shared_ptr<FSweepOptions> AddSweepFolder(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepOptions>();
	Verb.Add("DIR", Options->Folder, "Folder of the plan").Require();
	return Options;
}

} // namespace

FVerbCall AddSweepPlanOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepOptions>();
	Verb.Add("CONFIG", Options->Config, "JSON config with a sweep, such as configs/sweep.json").Require();
	Verb.Add("--out", Options->Folder, "Folder for the plan and all results").SetType("DIR").Require();
	Verb.AddFlag("--yes", Options->bYes, "Plan more than 10,000 tasks, or more than the disk has room for");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return CallWith(Options, PlanTasks);
}

FVerbCall AddSweepExecOptions(FVerbOptions& Verb)
{
	const auto Options = AddSweepFolder(Verb);
	FShardRequest& Shard = Options->Shard;
	const FVerbOption Of = Verb.Add("--of", Shard.Of, "Number of shards").RequireRange(1, 1'000'000).SetType("N");
	const FVerbOption Index = Verb.Add("--index", Shard.Index, "Run this shard, from 1 on; all tasks by default")
								  .RequireRange(1, 1'000'000)
								  .SetType("I")
								  .Need(Of);
	Verb.AddRepeated("--task", "HASH", Shard.Hashes, "Run this task, by the beginning of its hash; repeats")
		.Exclude(Index);
	Verb.Add("--threads", Shard.Threads, "Number of threads; 0: all cores (default)")
		.RequireRange(0, 1024)
		.SetType("N");
	Verb.AddFlag("--here", Options->bHere,
		"Run the tasks in this process, which a crash ends; by default another one runs them, and is started again");
	return CallWith(Options, ExecShard);
}

FVerbCall AddSweepSubmitOptions(FVerbOptions& Verb)
{
	const auto Options = AddSweepFolder(Verb);
	FSubmitRequest& Request = Options->Submit;
	Verb.Add("OPTION", Request.Options,
		"Behind --: the engine's own options, such as --sshlogin A,B of parallel or --partition=long of sbatch");
	Verb.Add("--engine", Request.Engine,
			"Run the shards in processes here (default), by GNU parallel, or as a Slurm job array. The page is made at "
			"the end; "
			"with Slurm a job makes it")
		.RequireOneOf(GetSweepEngines());
	Verb.Add("--shards", Request.NumShards, "Number of shards; by default the cores here, else ten minutes each")
		.RequireRange(1, 1'000'000)
		.SetType("N");
	return CallWith(Options, Submit);
}

FVerbCall AddSweepStatusOptions(FVerbOptions& Verb)
{
	const auto Options = AddSweepFolder(Verb);
	Verb.AddFlag("--follow", Options->bFollow, "Show a bar until every task is done or has failed");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return CallWith(Options, ShowStatus);
}

FVerbCall AddSweepReduceOptions(FVerbOptions& Verb)
{
	const auto Options = AddSweepFolder(Verb);
	AddReport(Verb, Options->Report, "sweep.html, the table with its pictures and plots");
	return CallWith(Options, ReduceResults);
}

} // namespace Drydock
