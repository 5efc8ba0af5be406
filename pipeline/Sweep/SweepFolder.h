// The folder of a sweep: plan.json and tasks.jsonl; results/HH/HASH, complete from the moment it exists; times/HH/HASH.json;
// failed/HASH.json, the messages of a task that failed; running/HASH, locked while a process is at it. Nothing in results
// depends on who computed it, or when.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepPlan.h"
#include "Text/FileList.h"
#include "Text/FolderLock.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** What a task took. */
struct FSweepTime
{
	double Seconds = 0.0; // of the whole task, by the clock
	int Threads = 0;
	std::string Host;
	std::string More = {}; // JSON: of a study its study_timing.json; empty: nothing
};

class DRYDOCK_API FSweepFolder
{
public:
	explicit FSweepFolder(std::filesystem::path InPath);

	const std::filesystem::path& GetPath() const { return Path; }

	/** Writes the plan in place of the one before; results stay. Throws FError (exit code 2 or 3) as FOutputFolder. */
	void WritePlan(const FSweepPlan& Plan) const;
	/** Throws FError (DD1141, exit code 2) where there is none, or one that is damaged. */
	FSweepPlan ReadPlan() const;

	std::filesystem::path GetResult(const FSweepTask& Task) const;
	/** Whether the result is there. It was complete when it was put there. */
	bool HasResult(const FSweepTask& Task) const;
	/** What is wrong with a result that is there: "final.png is empty"; empty: all is as it was written. */
	std::string FindFault(const FSweepTask& Task) const;
	/** Removes what drydock wrote of it. Throws FError (exit code 2) where there is more. */
	void RemoveResult(const FSweepTask& Task) const;

	void WriteTime(const FSweepTask& Task, const FSweepTime& Time) const;
	std::optional<FSweepTime> ReadTime(const FSweepTask& Task) const;

	/** Writes down why a task failed. */
	void WriteFailure(const FSweepTask& Task, const std::vector<FDiagnostic>& Messages) const;
	/** The messages; nothing where it did not fail. */
	std::optional<std::vector<FDiagnostic>> ReadFailure(const FSweepTask& Task) const;
	void RemoveFailure(const FSweepTask& Task) const;

	/** Keeps other processes from the task, on this machine and on others that see the folder. Null: one is at it. */
	std::unique_ptr<FFolderLock> TryLock(const FSweepTask& Task) const;
	/** Hashes of tasks that a process is at. */
	std::vector<std::string> FindRunning() const;
	/** Whether a process began the task and was ended in it. */
	bool WasAbandoned(const FSweepTask& Task) const;

private:
	const std::filesystem::path Path;
};

/** In a result: the list of its files. */
inline constexpr const char* SweepResultListName = ".drydock.result.files";

/** A line of tasks.jsonl. */
DRYDOCK_API std::string MakeTaskLine(const FSweepTask& Task);

} // namespace Drydock
