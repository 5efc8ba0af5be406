// Writes the scripts of engines, and calls them.
#include "Sweep/SweepSubmit.h"

#include "ChildProcess.h"
#include "ContentHash.h"
#include "Matrix/Matrix.h"
#include "Sweep/SweepErrors.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <thread>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr int MostEngineSeconds = 20 * 24 * 3600;

constexpr const char* ScriptRemark =
	"# You may change it and run it again. `drydock sweep submit` writes it anew.\n";

std::string JoinOptions(const std::vector<std::string>& Options)
{
	return JoinText(Options, "", [](const std::string& Word) { return QuoteForShell(Word) + " "; });
}

std::string GetFile(const FSubmitRequest& Request, const std::string& Name)
{
	return (Files::path(Request.Folder) / Name).string();
}

FError MakeEngineError(const std::string& Message, const std::string& File = "")
{
	return FError({.Code = ErrorSweepEngine, .Message = Message, .File = File}, ExitFiles);
}

void RequireEngine(const std::string& Program, const std::string& Package)
{
	if (FindProgram(Program).empty())
	{
		throw MakeEngineError(
			"there is no " + Program + " in PATH: Debian has it in the package " + Package + "; --engine local needs none");
	}
}

FSubmitResult SubmitHere(const FSubmitRequest& Request, const FSweepPlan& Plan, int NumShards)
{
	const int NumCores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
	std::vector<std::string> Failures(static_cast<size_t>(NumShards));
	{
		std::vector<std::jthread> Threads;
		for (int Shard = 0; Shard < NumShards; ++Shard)
		{
			Threads.emplace_back(
				[&, Shard]
				{
					try
					{
						RunShardApart({.Folder = Request.Folder,
							.Tasks = ChooseShard(Plan, Shard + 1, NumShards),
							.Threads = std::max(1, NumCores / NumShards),
							.Program = Request.Program,
							.Progress = {},
							.Report = {}});
					}
					catch (const std::exception& Error)
					{
						Failures[static_cast<size_t>(Shard)] = Error.what();
					}
				});
		}
	}
	std::erase(Failures, "");
	return {.bWaited = true, .Said = "", .Failures = Failures};
}

FSubmitResult SubmitToParallel(
	const FSubmitRequest& Request, const FSweepFolder& Folder, const FSweepPlan& Plan, int NumShards)
{
	RequireEngine("parallel", "parallel");
	std::string Lines;
	std::ranges::for_each(Plan.Tasks, [&](const FSweepTask& Task) { Lines += Task.Hash; });
	const std::string Log = GetFile(
		Request, fmt::format("parallel_{}_{}.joblog", HashBytes(Lines + JoinOptions(Request.Options)).substr(0, 8), NumShards));
	if (IsJoblogStale(TryReadTextFile(Log).value_or(""), Folder, Plan, NumShards))
	{
		Files::remove(Log);
	}
	const std::string Script = GetFile(Request, "parallel.sh");
	WriteTextFile(Script, MakeParallelScript(Request, Request.Program, NumShards, Log));
	const FChildResult Child = RunChild({"/bin/sh", Script}, MostEngineSeconds);
	constexpr int MostFailedJobs = 101; // its exit code counts jobs that failed
	if (!Child.bStarted || Child.Signal != 0 || Child.ExitCode > MostFailedJobs)
	{
		throw MakeEngineError("parallel " + Child.Describe(MostEngineSeconds) + ": " + Trim(Child.Output), Script);
	}
	return {.bWaited = true, .Said = Child.Output, .Failures = {}};
}

FSubmitResult SubmitToSlurm(const FSubmitRequest& Request, int NumShards)
{
	RequireEngine("sbatch", "slurm-client");
	std::error_code Ignored;
	Files::create_directories(GetFile(Request, "log"), Ignored);
	WriteTextFile(GetFile(Request, "slurm_array.sh"), MakeSlurmArrayScript(Request, Request.Program, NumShards));
	WriteTextFile(GetFile(Request, "slurm_reduce.sh"), MakeSlurmReduceScript(Request, Request.Program));
	const std::string Script = GetFile(Request, "slurm.sh");
	WriteTextFile(Script, MakeSlurmScript(Request));
	constexpr int MostSeconds = 600;
	const FChildResult Child = RunChild({"/bin/sh", Script}, MostSeconds);
	if (!Child.Succeeded())
	{
		throw MakeEngineError("sbatch " + Child.Describe(MostSeconds) + ": " + Trim(Child.Output), Script);
	}
	return {.bWaited = false, .Said = Child.Output, .Failures = {}};
}

std::string MakeSlurmHead(const FSubmitRequest& Request, const std::string& What, const std::string& Log)
{
	return "#!/bin/sh\n" + What + ScriptRemark + "#SBATCH --job-name=sweep_" +
		   Files::path(Request.Folder).filename().string() + "\n#SBATCH --output=\"" + GetFile(Request, "log/" + Log) +
		   "\"\n#SBATCH --open-mode=append\n#SBATCH --requeue\n";
}

} // namespace

const std::vector<std::string>& GetSweepEngineNames()
{
	static const std::vector<std::string> Names = {"local", "parallel", "slurm"};
	return Names;
}

int ChooseShardCount(const FSweepPlan& Plan, ESweepEngine Engine)
{
	constexpr double ShardSeconds = 600.0;
	constexpr int Least = 16, Most = 1000; // an array of Slurm has 1,001 elements at most by default
	const int NumTasks = static_cast<int>(std::max<size_t>(1, Plan.Tasks.size()));
	if (Engine == ESweepEngine::Local)
	{
		return std::min(NumTasks, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
	}
	const double Wanted = std::min(Plan.GetSeconds() / ShardSeconds, static_cast<double>(Most));
	return std::min(NumTasks, std::clamp(static_cast<int>(Wanted), Least, Most));
}

std::string MakeParallelScript(
	const FSubmitRequest& Request, const std::string& Program, int NumShards, const std::string& Log)
{
	return fmt::format("#!/bin/sh\n# Runs the shards of a sweep by GNU parallel; what its log has as done is left out.\n{}"
					   "seq 1 {} | exec parallel --will-cite --quote --joblog {} --resume --resume-failed {}\\\n"
					   "\t{} sweep exec {} --index {{}} --of {} --threads 1\n",
		ScriptRemark, NumShards, QuoteForShell(Log), JoinOptions(Request.Options), QuoteForShell(Program),
		QuoteForShell(Request.Folder), NumShards);
}

std::string MakeSlurmArrayScript(const FSubmitRequest& Request, const std::string& Program, int NumShards)
{
	return MakeSlurmHead(Request, "# One element of a job array: a shard of a sweep.\n", "shard_%a.txt") +
		   fmt::format("#SBATCH --array=1-{}\n"
					   "exec {} sweep exec {} --index \"$SLURM_ARRAY_TASK_ID\" --of {} --threads "
					   "\"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
			   NumShards, QuoteForShell(Program), QuoteForShell(Request.Folder), NumShards);
}

std::string MakeSlurmReduceScript(const FSubmitRequest& Request, const std::string& Program)
{
	return MakeSlurmHead(Request, "# The job that follows the array: makes table, plots and page.\n", "reduce.txt") +
		   fmt::format("exec {} sweep reduce {}\n", QuoteForShell(Program), QuoteForShell(Request.Folder));
}

std::string MakeSlurmScript(const FSubmitRequest& Request)
{
	const std::string Options = JoinOptions(Request.Options);
	return fmt::format("#!/bin/sh\n# Submits a job array and the job that follows it.\n{}set -e\n"
					   "Array=$(sbatch --parsable {}{})\n"
					   "Reduce=$(sbatch --parsable --dependency=afterany:\"${{Array%%;*}}\" {}{})\n"
					   "echo \"array $Array, reduce $Reduce\"\n",
		ScriptRemark, Options, QuoteForShell(GetFile(Request, "slurm_array.sh")), Options,
		QuoteForShell(GetFile(Request, "slurm_reduce.sh")));
}

bool IsJoblogStale(const std::string& Joblog, const FSweepFolder& Folder, const FSweepPlan& Plan, int NumShards)
{
	constexpr size_t ExitColumn = 6, SignalColumn = 7; // Seq Host Starttime JobRuntime Send Receive Exitval Signal Command
	for (const std::string& Line : SplitText(Joblog))
	{
		const std::vector<std::string> Cells = SplitText(Line, '\t');
		const std::optional<int> Shard = Cells.size() > SignalColumn ? ParseAll<int>(Cells[0]) : std::nullopt;
		if (!Shard || *Shard < 1 || *Shard > NumShards || Cells[ExitColumn] != "0" || Cells[SignalColumn] != "0")
		{
			continue;
		}
		const std::vector<size_t> Tasks = ChooseShard(Plan, *Shard, NumShards);
		if (!std::ranges::all_of(Tasks, [&](size_t Task) { return Folder.HasResult(Plan.Tasks[Task]); }))
		{
			return true;
		}
	}
	return false;
}

FSubmitResult SubmitSweep(const FSubmitRequest& Given)
{
	FSubmitRequest Request = Given;
	Request.Folder = (Files::absolute(Given.Folder) / "").lexically_normal().parent_path().string();
	Request.Program = Given.Program.empty() ? FindThisProgram() : Given.Program;
	const FSweepFolder Folder(Request.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	const int NumShards = Request.NumShards > 0 ? std::min<int>(Request.NumShards, static_cast<int>(Plan.Tasks.size()))
												: ChooseShardCount(Plan, Request.Engine);
	switch (Request.Engine)
	{
	case ESweepEngine::Parallel:
		return SubmitToParallel(Request, Folder, Plan, NumShards);
	case ESweepEngine::Slurm:
		return SubmitToSlurm(Request, NumShards);
	case ESweepEngine::Local:
		break;
	}
	return SubmitHere(Request, Plan, NumShards);
}

} // namespace Drydock
