// Goes through the tasks of a shard.
#include "Sweep/SweepExec.h"

#include "ChildProcess.h"
#include "Matrix/Matrix.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepFolder.h"
#include "Sweep/SweepInputs.h"
#include "Sweep/SweepRun.h"
#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/FileList.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace Drydock
{

namespace
{

/** The tasks of one process. */
class FShard
{
public:
	explicit FShard(const FShardRequest& Request)
		: Folder(Request.Folder)
		, Plan(Folder.ReadPlan())
		, Chosen(ChooseTasks(Plan, Request))
		, Inputs(Plan, false)
		, Runner(Plan, Request.Threads)
	{
	}

	FShardResult Run()
	{
		std::vector<size_t> Left = Chosen;
		while (!Left.empty())
		{
			const size_t NumBefore = Left.size();
			std::erase_if(Left, [this](size_t Task) { return Settle(Plan.Tasks[Task]); });
			if (Left.size() == NumBefore) // other processes are at them
			{
				std::this_thread::sleep_for(std::chrono::milliseconds(200));
			}
		}
		return Result;
	}

private:
	bool IsThere(const FSweepTask& Task)
	{
		const bool bThere = Folder.HasResult(Task) && Folder.HasGoodResult(Task);
		Result.NumThere += bThere ? 1 : 0;
		return bThere;
	}

	/** False while another process is at it. */
	bool Settle(const FSweepTask& Task)
	{
		std::unique_ptr<FFolderLock> Lock;
		try
		{
			if (IsThere(Task) || ((Lock = Folder.TryLock(Task)) && IsThere(Task))) // meanwhile
			{
				return true;
			}
			if (!Lock)
			{
				return false;
			}
			RunTask(Task);
			Folder.RemoveFailure(Task);
			++Result.NumDone;
		}
		catch (const FError& Error)
		{
			Result.Failures.push_back(
				DescribeTask(Plan, Task) + "\n" + JoinText(Error.GetDiagnostics(), "\n", &FDiagnostic::ToString));
			try
			{
				Folder.WriteFailure(Task, Error.GetDiagnostics());
			}
			catch (const FError&)
			{
				// The disk may be full: the messages are told, and the task is missing.
			}
		}
		return true;
	}

	void RequireUnchanged(const FSweepTask& Task)
	{
		if (Inputs.Hash(Task) != Task.Hash)
		{
			const std::string Key = FSweepInputs::NameFiles(Task);
			const auto Planned = Plan.Inputs.find(Key);
			const std::vector<std::string> Changes =
				DescribeChanges(Planned == Plan.Inputs.end() ? FRunInputs() : Planned->second, Inputs.GetInputs()[Key]);
			throw FError({.Code = ErrorSweepChanged,
							 .Message = "the task is not what was planned: " +
										(Changes.empty() ? "a frame of the scene has changed" : ListSome(Changes, 3)) +
										"; `drydock sweep plan` plans it as it is now",
							 .File = Plan.Config},
				ExitUsage);
		}
	}

	void RunTask(const FSweepTask& Task)
	{
		RequireUnchanged(Task);
		if (Folder.HasResult(Task))
		{
			Folder.RemoveResult(Task); // damaged
		}
		FAsideFile Aside(Folder.GetResult(Task));
		std::error_code Error;
		if (!std::filesystem::create_directory(Aside.GetPath(), Error))
		{
			throw MakeWriteError(Aside.GetPath().string(), Error.message());
		}
		const auto Begin = std::chrono::steady_clock::now();
		const std::string StudyTiming = Runner.Run(Task, Aside.GetPath());
		WriteWholeFile(Aside.GetPath() / SweepResultListName, FFileList::Make(Aside.GetPath(), {}).GetText());
		const std::chrono::duration<double> Seconds = std::chrono::steady_clock::now() - Begin;
		Folder.WriteTime(Task, Seconds.count(), StudyTiming); // first: where a result is, its time is
		Aside.PutInPlace();
	}

	const FSweepFolder Folder;
	const FSweepPlan Plan;
	const std::vector<size_t> Chosen;
	FSweepInputs Inputs;
	FSweepRunner Runner;
	FShardResult Result;
};

/** The last lines of what a process printed, as one. */
std::string TakeEnd(const std::string& Output)
{
	constexpr std::ptrdiff_t NumLines = 5;
	const std::vector<std::string> Lines = SplitText(Output);
	return JoinText(std::span(Lines).last(size_t(std::min(NumLines, std::ssize(Lines)))), "; ");
}

} // namespace

std::vector<size_t> ChooseTasks(const FSweepPlan& Plan, const FShardRequest& Request)
{
	std::vector<size_t> Chosen;
	if (Request.Index > Request.Of)
	{
		throw BadArgument(
			"there is no shard " + std::to_string(Request.Index) + " of " + std::to_string(Request.Of), "--index");
	}
	for (size_t Task = size_t(Request.Index - 1); Request.Hashes.empty() && Task < Plan.Tasks.size();
		 Task += size_t(Request.Of))
	{
		Chosen.push_back(Task);
	}
	for (const std::string& Hash : Request.Hashes)
	{
		const auto Found =
			std::ranges::find_if(Plan.Tasks, [&](const FSweepTask& Task) { return Task.Hash.starts_with(Hash); });
		if (Found == Plan.Tasks.end())
		{
			throw BadArgument("there is no task with the hash " + Hash, "--task");
		}
		Chosen.push_back(size_t(Found - Plan.Tasks.begin()));
	}
	return Chosen;
}

FShardResult RunShard(const FShardRequest& Request)
{
	return FShard(Request).Run();
}

FShardResult RunShardApart(const FShardRequest& Request)
{
	constexpr int MostSeconds = 20 * 24 * 3600;
	constexpr size_t MostTasks = 10'000; // of one process: a command line has an end
	const FSweepFolder Folder(Request.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	const std::vector<size_t> Chosen = ChooseTasks(Plan, Request);
	FShardResult Result;
	std::vector<size_t> Left;
	for (const size_t Task : Chosen)
	{
		if (Folder.HasResult(Plan.Tasks[Task]) && Folder.HasGoodResult(Plan.Tasks[Task]))
		{
			++Result.NumThere;
			continue;
		}
		Left.push_back(Task);
		Folder.RemoveFailure(Plan.Tasks[Task]);
		Folder.TryLock(Plan.Tasks[Task]); // and away: what a killed process left is gone, so that a crash can be told
	}
	const size_t NumAsked = Left.size();
	for (size_t NumBefore = NumAsked + 1; !Left.empty() && Left.size() < NumBefore;)
	{
		NumBefore = Left.size();
		std::vector<std::string> Arguments = {FindThisProgram(), "sweep", "exec", Request.Folder, "--here", "--threads",
			std::to_string(Request.Threads.value_or(0))};
		// Tasks that name a plugin or an overlay share a process only with those that name the same.
		const FSweepTask& First = Plan.Tasks[Left[0]];
		for (size_t NumTasks = 0; const size_t Task : Left)
		{
			if (NumTasks < MostTasks &&
				(FSweepInputs::NameFiles(Plan.Tasks[Task]) == FSweepInputs::NameFiles(First) ||
					!(FSweepInputs::NamesCode(Plan.Tasks[Task]) || FSweepInputs::NamesCode(First))))
			{
				Arguments.insert(Arguments.end(), {"--task", Plan.Tasks[Task].Hash});
				++NumTasks;
			}
		}
		const FChildResult Child = RunChild(Arguments, MostSeconds);
		const bool bCrashed = Child.Signal != 0 || Child.ExitCode >= ExitInternal;
		if (!Child.bStarted || Child.bTimedOut || (!bCrashed && Child.ExitCode > ExitPolicy))
		{
			throw FError(
				{.Code = ErrorSweepEngine,
					.Message = "the process of a shard " + Child.Describe(MostSeconds) + ": " + TakeEnd(Child.Output),
					.File = Request.Folder},
				ExitFiles);
		}
		for (const size_t Task : Left)
		{
			if (bCrashed && Folder.WasAbandoned(Plan.Tasks[Task]))
			{
				Folder.WriteFailure(
					Plan.Tasks[Task], {{.Code = ErrorSweepCrash,
										  .Message = "the process that ran this task " + Child.Describe(MostSeconds) +
													 ": " + TakeEnd(Child.Output),
										  .File = Plan.Config}});
				Folder.TryLock(Plan.Tasks[Task]);
			}
		}
		std::erase_if(Left,
			[&](size_t Task) { return Folder.HasResult(Plan.Tasks[Task]) || Folder.ReadFailure(Plan.Tasks[Task]); });
	}
	for (const size_t Task : Chosen)
	{
		const bool bLeft = std::ranges::count(Left, Task) > 0;
		if (const std::optional<std::string> Failure = Folder.ReadFailure(Plan.Tasks[Task]); Failure || bLeft)
		{
			Result.Failures.push_back(
				DescribeTask(Plan, Plan.Tasks[Task]) + "\n" + Failure.value_or("its process ends before it begins"));
		}
	}
	Result.NumDone = int(NumAsked) - int(Result.Failures.size());
	return Result;
}

} // namespace Drydock
