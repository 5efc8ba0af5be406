// Goes through the tasks of a shard.
#include "Sweep/SweepExec.h"

#include "ChildProcess.h"
#include "Matrix/Matrix.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepInputs.h"
#include "Sweep/SweepRun.h"
#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <span>
#include <thread>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** The tasks of one process. */
class FShard
{
public:
	explicit FShard(const FShardRequest& InRequest)
		: Request(InRequest)
		, Folder(InRequest.Folder)
		, Plan(Folder.ReadPlan())
		, Inputs(Plan)
		, Runner(Plan, InRequest.Threads)
	{
	}

	FShardResult Run()
	{
		std::deque<size_t> Pending(Request.Tasks.begin(), Request.Tasks.end());
		size_t NumHeld = 0; // tasks in a row that other processes are at
		while (!Pending.empty())
		{
			const FSweepTask& Task = Plan.Tasks[Pending.front()];
			ShowProgress(DescribeTask(Plan, Task));
			if (!Settle(Task))
			{
				Pending.push_back(Pending.front());
				NumHeld = NumHeld + 1 < Pending.size() ? NumHeld + 1 : 0;
				if (NumHeld == 0)
				{
					std::this_thread::sleep_for(std::chrono::milliseconds(200));
				}
			}
			Pending.pop_front();
		}
		ShowProgress("");
		return Result;
	}

private:
	void ShowProgress(const std::string& What) const
	{
		if (Request.Progress)
		{
			Request.Progress(Result.NumDone + Result.NumThere + Result.NumFailed,
				static_cast<int>(Request.Tasks.size()), What);
		}
	}

	bool IsFinished(const FSweepTask& Task) const
	{
		return Folder.HasResult(Task) && Folder.FindFault(Task).empty();
	}

	/** False while another process is at it. */
	bool Settle(const FSweepTask& Task)
	{
		if (IsFinished(Task))
		{
			++Result.NumThere;
			return true;
		}
		const std::unique_ptr<FFolderLock> Lock = Folder.TryLock(Task);
		if (!Lock)
		{
			return false;
		}
		if (IsFinished(Task)) // meanwhile
		{
			++Result.NumThere;
			return true;
		}
		try
		{
			RunTask(Task);
			Folder.RemoveFailure(Task);
			++Result.NumDone;
		}
		catch (const FError& Error)
		{
			++Result.NumFailed;
			if (Request.Report)
			{
				Request.Report(Task, Error.GetDiagnostics());
			}
			try
			{
				Folder.WriteFailure(Task, Error.GetDiagnostics());
			}
			catch (const FError&)
			{
				// The disk may be full: the messages were reported.
			}
		}
		return true;
	}

	/** A hash is looked at before each task: files may change while thousands run. */
	void RequireUnchanged(const FSweepTask& Task)
	{
		if (!bPrepared)
		{
			std::ranges::for_each(Plan.Tasks, [&](const FSweepTask& Each) { Inputs.Prepare(Each); });
			bPrepared = true;
		}
		if (Inputs.Hash(Task) == Task.Hash)
		{
			return;
		}
		const std::string Key = NameTaskFiles(Task);
		const auto Planned = Plan.Inputs.find(Key);
		const std::vector<std::string> Changes = DescribeChanges(
			Planned == Plan.Inputs.end() ? FRunInputs() : Planned->second, Inputs.GetInputs()[Key]);
		throw FError({.Code = ErrorSweepChanged,
						 .Message = "the task is not what was planned: " +
									(Changes.empty() ? "a frame of the scene has changed" : ListSome(Changes, 3)) +
									"; `drydock sweep plan` plans it as it is now",
						 .File = Plan.Config},
			ExitUsage);
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
		if (!Files::create_directory(Aside.GetPath(), Error))
		{
			throw MakeWriteError(Aside.GetPath().string(), Error.message());
		}
		const FSweepTime Time = Runner.Run(Task, Aside.GetPath());
		const FFileList List = FFileList::Make(Aside.GetPath(), {});
		WriteWholeFile((Aside.GetPath() / SweepResultListName).string(), List.GetText());
		Folder.WriteTime(Task, Time); // first: where a result is, its time is
		Aside.PutInPlace();
	}

	const FShardRequest& Request;
	const FSweepFolder Folder;
	const FSweepPlan Plan;
	FSweepInputs Inputs;
	bool bPrepared = false;
	FSweepRunner Runner;
	FShardResult Result;
};

bool IsCrash(const FChildResult& Child)
{
	return Child.Signal != 0 || Child.bTimedOut || Child.ExitCode == ExitPlugin || Child.ExitCode == ExitInternal;
}

/** The last lines of what a process printed, as one text. */
std::string TakeEnd(const std::string& Output)
{
	constexpr size_t NumLines = 5;
	std::vector<std::string> Lines = SplitText(Output);
	Lines.erase(Lines.begin(), Lines.end() - static_cast<std::ptrdiff_t>(std::min(NumLines, Lines.size())));
	return JoinText(Lines, "; ");
}

} // namespace

std::vector<size_t> ChooseShard(const FSweepPlan& Plan, int Index, int Count)
{
	std::vector<size_t> Chosen;
	for (size_t Task = static_cast<size_t>(Index - 1); Task < Plan.Tasks.size(); Task += static_cast<size_t>(Count))
	{
		Chosen.push_back(Task);
	}
	return Chosen;
}

std::vector<size_t> FindTasks(const FSweepPlan& Plan, const std::vector<std::string>& Hashes)
{
	std::vector<size_t> Found;
	for (const std::string& Hash : Hashes)
	{
		std::vector<size_t> Fits;
		for (size_t Index = 0; Index < Plan.Tasks.size(); ++Index)
		{
			if (Plan.Tasks[Index].Hash.starts_with(Hash) &&
				(Fits.empty() || Plan.Tasks[Index].Hash != Plan.Tasks[Fits[0]].Hash))
			{
				Fits.push_back(Index);
			}
		}
		if (Fits.size() != 1)
		{
			throw BadArgument(
				(Fits.empty() ? "no task has the hash " : "several tasks have a hash that begins with ") + Hash, "--task");
		}
		Found.push_back(Fits[0]);
	}
	return Found;
}

FShardResult RunShard(const FShardRequest& Request)
{
	return FShard(Request).Run();
}

FShardResult RunShardApart(const FShardRequest& Request)
{
	constexpr int MostSeconds = 20 * 24 * 3600; // of a process
	constexpr std::ptrdiff_t MostTasks = 10'000; // of a process: a command line has an end
	const FSweepFolder Folder(Request.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	const std::string Program = Request.Program.empty() ? FindThisProgram() : Request.Program;
	FShardResult Result;
	std::vector<size_t> Left;
	for (const size_t Task : Request.Tasks)
	{
		if (Folder.HasResult(Plan.Tasks[Task]) && Folder.FindFault(Plan.Tasks[Task]).empty())
		{
			++Result.NumThere;
			continue;
		}
		Left.push_back(Task);
		Folder.RemoveFailure(Plan.Tasks[Task]);
		Folder.TryLock(Plan.Tasks[Task]); // and away: what a killed process left is gone, so a crash can be told
	}
	const size_t NumAsked = Left.size();
	while (!Left.empty())
	{
		std::vector<std::string> Arguments = {Program, "sweep", "exec", Request.Folder, "--here"};
		if (Request.Threads)
		{
			Arguments.insert(Arguments.end(), {"--threads", std::to_string(*Request.Threads)});
		}
		const size_t NumBefore = Left.size();
		const std::span<const size_t> Batch(Left.begin(), Left.begin() + std::min(MostTasks, std::ssize(Left)));
		for (const size_t Task : Batch)
		{
			Arguments.insert(Arguments.end(), {"--task", Plan.Tasks[Task].Hash});
		}
		const FChildResult Child = RunChild(Arguments, MostSeconds);
		if (!Child.bStarted)
		{
			throw FError(
				{.Code = ErrorSweepEngine, .Message = "cannot be started to run a shard", .File = Program}, ExitFiles);
		}
		if (!IsCrash(Child) && Child.ExitCode > ExitPolicy)
		{
			throw FError({.Code = ErrorSweepEngine,
							 .Message = "the process of a shard " + Child.Describe(MostSeconds) + ": " +
										TakeEnd(Child.Output),
							 .File = Request.Folder},
				ExitFiles);
		}
		for (const size_t Task : Left)
		{
			if (IsCrash(Child) && Folder.WasAbandoned(Plan.Tasks[Task]))
			{
				Folder.WriteFailure(Plan.Tasks[Task],
					{{.Code = ErrorSweepCrash,
						.Message = "the process that ran this task " + Child.Describe(MostSeconds) + ": " +
								   TakeEnd(Child.Output),
						.File = Plan.Config}});
				Folder.TryLock(Plan.Tasks[Task]);
			}
		}
		std::erase_if(Left, [&](size_t Task)
			{ return Folder.HasResult(Plan.Tasks[Task]) || Folder.ReadFailure(Plan.Tasks[Task]); });
		if (Left.size() == NumBefore)
		{
			break; // it ends before it begins
		}
	}
	for (const size_t Task : Request.Tasks)
	{
		const std::optional<std::vector<FDiagnostic>> Messages = Folder.ReadFailure(Plan.Tasks[Task]);
		Result.NumFailed += Messages ? 1 : 0;
		if (Messages && Request.Report)
		{
			Request.Report(Plan.Tasks[Task], *Messages);
		}
	}
	Result.NumFailed += static_cast<int>(Left.size());
	Result.NumDone = static_cast<int>(NumAsked) - Result.NumFailed;
	return Result;
}

} // namespace Drydock
