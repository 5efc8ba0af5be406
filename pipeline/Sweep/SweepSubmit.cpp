// Writes the scripts of engines, and calls them.
#include "Sweep/SweepSubmit.h"

#include "ChildProcess.h"
#include "ContentHash.h"
#include "Matrix/Matrix.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepExec.h"
#include "Text/Fmt.inl"
#include "Text/ShellText.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <thread>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

int GetNumCores()
{
	return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace

const std::vector<std::string>& GetSweepEngines()
{
	static const std::vector<std::string> Names = {"local", "parallel", "slurm"};
	return Names;
}

int ChooseShardCount(const FSweepPlan& Plan, const std::string& Engine)
{
	constexpr double ShardSeconds = 600.0;
	constexpr double Least = 16.0, Most = 1000.0; // an array of Slurm has 1,001 elements at most by default
	const double Wanted = std::clamp(Plan.GetSeconds() / ShardSeconds, Least, Most);
	return std::min(int(Plan.Tasks.size()), Engine == "local" ? GetNumCores() : int(Wanted));
}

std::vector<std::pair<std::string, std::string>> MakeSubmitScripts(
	const FSubmitRequest& Request, const std::string& Program, const std::string& Joblog)
{
	const std::string Remark = "# You may change it and run it again. `drydock sweep submit` writes it anew.\n";
	const std::string Folder = QuoteForShell(Request.Folder), Sweep = QuoteForShell(Program) + " sweep ";
	const std::string Options =
		JoinText(Request.Options, "", [](const std::string& One) { return QuoteForShell(One) + " "; });
	const int N = Request.NumShards;
	if (Request.Engine == "local")
	{
		return {{"local.sh",
			fmt::format(
				"#!/bin/sh\n# Runs the shards of a sweep in {0} processes.\n{1}seq 1 {0} | exec xargs -P {0} -I '{{}}' "
				"{2}exec {3} --index '{{}}' --of {0} --threads {4}\n",
				N, Remark, Sweep, Folder, std::max(1, GetNumCores() / N))}};
	}
	if (Request.Engine == "parallel")
	{
		return {{"parallel.sh",
			fmt::format(
				"#!/bin/sh\n# Runs the shards of a sweep by GNU parallel. It leaves out the shards that the log has as "
				"done.\n{}"
				"seq 1 {} | exec parallel --will-cite --quote --joblog {} --resume --resume-failed {}\\\n\t{}exec {} "
				"--index '{{}}' --of {} --threads 1\n",
				Remark, N, QuoteForShell(Joblog), Options, Sweep, Folder, N)}};
	}
	const auto MakeHead = [&](const std::string& What, const std::string& Log)
	{
		return fmt::format("#!/bin/sh\n# {}\n{}#SBATCH --job-name=sweep\n#SBATCH --output=\"{}/log/{}.txt\"\n"
						   "#SBATCH --open-mode=append\n#SBATCH --requeue\n",
			What, Remark, Request.Folder, Log);
	};
	return {
		{"slurm.sh",
			fmt::format("#!/bin/sh\n# Submits a job array, and the job that follows it.\n{0}set -e\n"
						"Array=$(sbatch --parsable {1}{2}/slurm_array.sh)\n"
						"Reduce=$(sbatch --parsable --dependency=afterany:\"${{Array%%;*}}\" {1}{2}/slurm_reduce.sh)\n"
						"echo \"array $Array, reduce $Reduce\"\n",
				Remark, Options, Folder)},
		{"slurm_array.sh",
			MakeHead("One element of a job array: a shard of a sweep.", "shard_%a") +
				fmt::format(
					"#SBATCH --array=1-{0}\nexec {1}exec {2} --index \"$SLURM_ARRAY_TASK_ID\" --of {0} --threads "
					"\"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
					N, Sweep, Folder)},
		{"slurm_reduce.sh", MakeHead("Makes the table, the plots and the page of a sweep.", "reduce") +
								fmt::format("exec {}reduce {}\n", Sweep, Folder)}};
}

bool IsJoblogStale(const std::string& Joblog, const FSweepFolder& Folder, const FSweepPlan& Plan, int NumShards)
{
	constexpr size_t ExitColumn = 6,
					 SignalColumn = 7; // Seq Host Starttime JobRuntime Send Receive Exitval Signal Command
	for (const std::string& Line : SplitText(Joblog))
	{
		const std::vector<std::string> Cells = SplitText(Line, '\t');
		const int Shard = Cells.size() > SignalColumn ? ParseAll<int>(Cells[0]).value_or(0) : 0;
		if (Shard < 1 || Shard > NumShards || Cells[ExitColumn] != "0" || Cells[SignalColumn] != "0")
		{
			continue;
		}
		const std::vector<size_t> Tasks = ChooseTasks(Plan, {"", {}, Shard, NumShards, {}});
		if (!std::ranges::all_of(Tasks, [&](size_t Task) { return Folder.HasResult(Plan.Tasks[Task]); }))
		{
			return true;
		}
	}
	return false;
}

std::string SubmitSweep(const FSubmitRequest& Given)
{
	constexpr int MostSeconds = 20 * 24 * 3600;
	FSubmitRequest Request = Given;
	Request.Folder = (Files::absolute(Given.Folder) / "").lexically_normal().parent_path().string();
	const FSweepFolder Folder(Request.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	Request.NumShards = std::min(
		int(Plan.Tasks.size()), Given.NumShards > 0 ? Given.NumShards : ChooseShardCount(Plan, Request.Engine));
	const auto Fail = [](const std::string& Message, const std::string& File)
	{
		return FError({.Code = ErrorSweepEngine, .Message = Message, .File = File}, ExitFiles);
	};
	const std::string Needed = Request.Engine == "slurm"      ? "sbatch"
							   : Request.Engine == "parallel" ? "parallel"
															  : "xargs";
	if (FindProgram(Needed).empty())
	{
		throw Fail("there is no " + Needed + " in PATH, which --engine " + Request.Engine + " calls", "");
	}
	const std::string Key = HashBytes(JoinText(Plan.Tasks, "", &FSweepTask::Hash)).substr(0, 8);
	const std::string Joblog = fmt::format("{}/parallel_{}_{}.joblog", Request.Folder, Key, Request.NumShards);
	if (IsJoblogStale(TryReadTextFile(Joblog).value_or(""), Folder, Plan, Request.NumShards))
	{
		Files::remove(Joblog);
	}
	const auto Scripts = MakeSubmitScripts(Request, FindThisProgram(), Joblog);
	for (const auto& [Name, Text] : Scripts)
	{
		WriteTextFile(Request.Folder + "/" + Name, Text);
	}
	std::error_code Ignored;
	Files::create_directories(Files::path(Request.Folder) / "log", Ignored); // of Slurm, which makes none
	const std::string Script = Request.Folder + "/" + Scripts[0].first;
	const FChildResult Child = RunChild({"/bin/sh", Script}, MostSeconds);
	// xargs and parallel count shards that failed; their tasks have messages. Slurm has run nothing yet.
	constexpr int MostCounted = 123;
	if (!Child.bStarted || Child.Signal != 0 || Child.ExitCode > (Request.Engine == "slurm" ? 0 : MostCounted))
	{
		throw Fail(Needed + " " + Child.Describe(MostSeconds) + ": " + Trim(Child.Output), Script);
	}
	return Child.Output;
}

} // namespace Drydock
