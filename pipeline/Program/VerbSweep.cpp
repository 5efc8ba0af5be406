// `drydock sweep plan`, `exec` and `status`: thousands of frames and configurations as tasks, run shard by shard.
#include "Config/ReadConfig.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/VerbOptions.h"
#include "Program/VerbSweep.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepExec.h"
#include "Sweep/SweepRun.h"
#include "Sweep/SweepStatus.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <future>
#include <memory>
#include <thread>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr size_t MostTasksUnasked = 10'000;

struct FSweepPlanOptions
{
	std::string Config;
	std::string Folder;
	bool bYes = false;
	bool bJson = false;
};

struct FSweepExecOptions
{
	std::string Folder;
	int Index = 1;
	int Of = 1;
	std::vector<std::string> Hashes;
	std::optional<int> Threads;
	bool bHere = false;
};

struct FSweepStatusOptions
{
	std::string Folder;
	bool bFollow = false;
	bool bJson = false;
};

FError MakeLargeError(const std::string& Why, const std::string& File)
{
	return FError({.Code = ErrorSweepLarge, .Message = Why + ": --yes goes on", .File = File}, ExitUsage);
}

/** The sweep of a config, read with its plugins, which bring settings and variables. */
FSweep ReadSweepFile(const std::string& File)
{
	std::vector<FDiagnostic> Found;
	try
	{
		FRunOptions Options;
		Options.ConfigFile = File;
		const FRunSetup Setup(Options);
		const FSweep Sweep = ReadSweep(Setup.Config, Found);
		if (HasErrors(Found))
		{
			throw FError(Found, ExitUsage);
		}
		PrintDiagnostics(Found);
		return Sweep;
	}
	catch (const FError& Error)
	{
		if (HasErrors(Found))
		{
			throw;
		}
		// Mistakes of the sweep stand beside those of the config; names of plugins that could not be loaded are among them.
		std::vector<FDiagnostic> All = Error.GetDiagnostics();
		std::vector<FDiagnostic> Ignored;
		const FConfig Config = LoadConfig(File, Ignored);
		if (Config.Sweep.Type == EJsonType::Object)
		{
			ReadSweep(Config, All);
		}
		throw FError(All, Error.GetExitCode());
	}
}

std::string DescribeAxes(const FSweepPlan& Plan)
{
	return JoinText(Plan.Axes, " x ",
		[](const FSweepAxis& Axis) { return Axis.Name + " " + std::to_string(Axis.Values.size()); });
}

std::string MakePlanText(const FSweepPlan& Plan, const std::string& Folder, uint64_t FreeBytes, size_t NumDone)
{
	const bool bFrames = Plan.Task == ESweepTask::Run;
	return fmt::format("tasks    {} ({}){}\n", Plan.Tasks.size(), DescribeAxes(Plan),
			   NumDone > 0 ? fmt::format(", {} of them done", NumDone) : "") +
		   fmt::format("time     {} in one process, by a {} that took {}\n", DescribeDuration(Plan.GetSeconds()),
			   bFrames ? "frame" : "task", DescribeDuration(Plan.Cost.Seconds)) +
		   fmt::format("disk     {}, {} are free\n", DescribeBytes(static_cast<double>(Plan.GetBytes())),
			   DescribeBytes(static_cast<double>(FreeBytes))) +
		   fmt::format("folder   {}\n", Folder);
}

std::string MakePlanSummaryJson(const FSweepPlan& Plan, const std::string& Folder, uint64_t FreeBytes, size_t NumDone)
{
	FJsonWriter Writer('{');
	Writer.Members({{"tasks", static_cast<uint64_t>(Plan.Tasks.size())}, {"done", static_cast<uint64_t>(NumDone)},
		{"seconds", Plan.GetSeconds()}, {"bytes", Plan.GetBytes()}, {"freeBytes", FreeBytes}, {"folder", Folder}});
	return Writer.GetText();
}

int PlanSweepFile(const FSweepPlanOptions& Options)
{
	const FSweep Sweep = ReadSweepFile(Options.Config);
	const size_t NumCombinations = CountCombinations(Sweep);
	if (NumCombinations > MostTasksUnasked && !Options.bYes)
	{
		throw MakeLargeError(fmt::format("the axes make {} tasks", NumCombinations), Options.Config);
	}
	std::vector<FDiagnostic> Remarks;
	FSweepPlan Plan = PlanSweep(Sweep, Remarks);
	PrintDiagnostics(Remarks);
	if (Plan.Tasks.size() > MostTasksUnasked && !Options.bYes)
	{
		throw MakeLargeError(fmt::format("the sweep has {} tasks", Plan.Tasks.size()), Options.Config);
	}
	const FSweepFolder Folder(Options.Folder);
	Plan.Cost = MeasureSweep(Plan, Folder);
	const uint64_t FreeBytes = Files::space(Options.Folder).available;
	const uint64_t Bytes = Plan.GetBytes();
	if (Bytes > FreeBytes && !Options.bYes)
	{
		throw MakeLargeError(fmt::format("the results take {}, and {} are free", DescribeBytes(static_cast<double>(Bytes)),
								 DescribeBytes(static_cast<double>(FreeBytes))),
			Options.Folder);
	}
	Folder.WritePlan(Plan);
	const size_t NumDone = CountDone(Folder, Plan);
	PrintResult(Options.bJson ? MakePlanSummaryJson(Plan, Options.Folder, FreeBytes, NumDone)
							  : MakePlanText(Plan, Options.Folder, FreeBytes, NumDone),
		Options.bJson);
	return ExitDone;
}

int ExecShard(const FSweepExecOptions& Options)
{
	const FSweepFolder Folder(Options.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	if (Options.Index > Options.Of)
	{
		throw BadArgument(fmt::format("is {}, and there are {} shards", Options.Index, Options.Of), "--index");
	}
	FShardRequest Request{.Folder = Options.Folder,
		.Tasks = Options.Hashes.empty() ? ChooseShard(Plan, Options.Index, Options.Of) : FindTasks(Plan, Options.Hashes),
		.Threads = Options.Threads,
		.Program = "",
		.Progress = {},
		.Report = [&Plan](const FSweepTask& Task, const std::vector<FDiagnostic>& Messages)
		{
			PrintDiagnostics({{.Severity = ESeverity::Note,
				.Message = "this task failed: " + DescribeTask(Plan, Task),
				.Where = "task " + Task.Hash}});
			PrintDiagnostics(Messages);
		}};
	const FShardResult Result =
		Options.bHere ? RunShard(Request) : CallWithSweepBar(Folder, Plan, [&] { return RunShardApart(Request); });
	PrintResult(fmt::format("{} tasks: {} run, {} were there, {} failed\n", Request.Tasks.size(), Result.NumDone,
		Result.NumThere, Result.NumFailed));
	return Result.NumFailed > 0 ? ExitPolicy : ExitDone;
}

int ShowStatus(const FSweepStatusOptions& Options)
{
	const FSweepFolder Folder(Options.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	if (Options.bFollow)
	{
		CallWithSweepBar(Folder, Plan,
			[&]
			{
				while (!FindSweepStatus(Folder, Plan).IsSettled())
				{
					std::this_thread::sleep_for(std::chrono::seconds(1));
				}
				return 0;
			});
	}
	const FSweepStatus Status = FindSweepStatus(Folder, Plan);
	PrintResult(Options.bJson ? MakeStatusJson(Status)
							  : MakeStatusText(Status, GetOutputWidth(), GetOutputWidth() > 0),
		Options.bJson);
	return Status.NumFailed > 0 ? ExitPolicy : ExitDone;
}

} // namespace

void ShowSweepBar(const FSweepFolder& Folder, const FSweepPlan& Plan, const std::function<bool()>& IsOver)
{
	FProgressBar Bar;
	const size_t NumBefore = CountDone(Folder, Plan);
	const auto Begin = std::chrono::steady_clock::now();
	while (!IsOver())
	{
		const size_t NumDone = CountDone(Folder, Plan);
		const double Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
		const double Left = NumDone > NumBefore ? Seconds / static_cast<double>(NumDone - NumBefore) *
													  static_cast<double>(Plan.Tasks.size() - NumDone)
												: Plan.GetSeconds();
		Bar.Show(static_cast<int>(NumDone), static_cast<int>(Plan.Tasks.size()),
			"tasks, " + DescribeDuration(Left) + " left");
	}
}

FVerbCall AddSweepPlanOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepPlanOptions>();
	Verb.Add("CONFIG", Options->Config, "JSON config with a sweep, such as configs/sweep.json").Require();
	Verb.Add("--out", Options->Folder, "Folder for the plan and all results").SetType("DIR").Require();
	Verb.AddFlag("--yes", Options->bYes, "Plan more than 10,000 tasks, or more than the disk has room for");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return CallWith(Options, PlanSweepFile);
}

FVerbCall AddSweepExecOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepExecOptions>();
	Verb.Add("DIR", Options->Folder, "Folder of the plan").Require();
	const FVerbOption Index =
		Verb.Add("--index", Options->Index, "Run this shard, from 1 on; all tasks by default").SetType("I");
	const FVerbOption Of = Verb.Add("--of", Options->Of, "Number of shards").RequireRange(1, 1'000'000).SetType("N");
	Index.RequireRange(1, 1'000'000).Need(Of);
	Of.Need(Index);
	Verb.AddRepeated("--task", "HASH", Options->Hashes, "Run this task, by the beginning of its hash; repeats")
		.Exclude(Index);
	Verb.Add("--threads", Options->Threads, "Number of threads; 0: all cores (default)").RequireRange(0, 1024).SetType("N");
	Verb.AddFlag("--here", Options->bHere,
		"Run the tasks in this process, where a crash ends all; by default a process of their own is started again");
	return CallWith(Options, ExecShard);
}

FVerbCall AddSweepStatusOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepStatusOptions>();
	Verb.Add("DIR", Options->Folder, "Folder of the plan").Require();
	Verb.AddFlag("--follow", Options->bFollow, "Show a bar until every task is done or has failed");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return CallWith(Options, ShowStatus);
}

} // namespace Drydock
