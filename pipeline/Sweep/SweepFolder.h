// The folder of a sweep. It holds plan.json and tasks.jsonl; results/HH/HASH, complete from the moment it exists, and
// times/HH/HASH.json. A task that failed has its messages in failed/HASH.json. running/HASH is locked while a process
// is at the task. Nothing in results depends on who computed it, or when.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepPlan.h"
#include "Text/FolderLock.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** How far a sweep is. */
struct FSweepStatus
{
	size_t NumTasks = 0;
	size_t NumDone = 0;
	size_t NumRunning = 0; // a process is at them now
	size_t NumFailed = 0;
	size_t NumMissing = 0;             // neither done, nor running, nor failed
	double SecondsPerTask = 0.0;       // mean of tasks that are done; of none as it was planned
	std::optional<double> SecondsLeft; // with as many processes as run now; none: none runs
	std::vector<std::string> Failures; // "HASH values: first message"
};

class DRYDOCK_API FSweepFolder
{
public:
	explicit FSweepFolder(const std::filesystem::path& InPath)
		: Path(InPath)
	{
	}

	const std::filesystem::path& GetPath() const { return Path; }

	/** In place of the plan before; results stay. Throws FError (exit code 2 or 3) as FOutputFolder. */
	void WritePlan(const FSweepPlan& Plan) const;
	/** Throws FError (DD1141, exit code 2) where there is none, or one that is damaged. */
	FSweepPlan ReadPlan() const;

	std::filesystem::path GetResult(const FSweepTask& Task) const;
	/** Whether the result is there. It was complete when it was put there. */
	bool HasResult(const FSweepTask& Task) const;
	/** Whether it is there as it was written. */
	bool HasGoodResult(const FSweepTask& Task) const;
	/** Removes what drydock wrote of it. Throws FError (exit code 2) where there is more. */
	void RemoveResult(const FSweepTask& Task) const;

	/** The time that a task took, and study_timing.json where it is a study. */
	void WriteTime(const FSweepTask& Task, double Seconds, const std::string& StudyTiming) const;
	std::optional<double> ReadSeconds(const FSweepTask& Task) const;

	/** Writes down why a task failed. */
	void WriteFailure(const FSweepTask& Task, const std::vector<FDiagnostic>& Messages) const;
	/** The messages, a line each; nothing where it did not fail. */
	std::optional<std::string> ReadFailure(const FSweepTask& Task) const;
	void RemoveFailure(const FSweepTask& Task) const;

	/** Keeps other processes from the task, on all machines that see the folder. Null: one is at it. */
	std::unique_ptr<FFolderLock> TryLock(const FSweepTask& Task) const;
	/** Whether a process is at the task. */
	bool IsRunning(const FSweepTask& Task) const;
	/** Whether a process was ended in the midst of it. */
	bool WasAbandoned(const FSweepTask& Task) const;

	size_t CountDone(const FSweepPlan& Plan) const;
	FSweepStatus FindStatus(const FSweepPlan& Plan) const;

private:
	std::filesystem::path GetRunning(const FSweepTask& Task) const { return Path / "running" / Task.Hash; }
	std::filesystem::path GetTime(const FSweepTask& Task) const;

	const std::filesystem::path Path;
};

/** In a result: the list of its files. */
inline constexpr const char* SweepResultListName = ".drydock.result.files";

} // namespace Drydock
