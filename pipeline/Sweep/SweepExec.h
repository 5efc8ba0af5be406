// Runs a shard: tasks of a plan in this process, or in a process for all of them that is watched, so that a crash costs the
// one task that made it.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepFolder.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FShardRequest
{
	std::string Folder;
	std::vector<size_t> Tasks; // indices into the plan, in the order in which they run
	std::optional<int> Threads;
	std::string Program; // drydock's own, for a process of its own; empty: this process's
	/** Called before each task and after the last, Done of Total. */
	std::function<void(int Done, int Total, const std::string& What)> Progress;
	/** Called with the messages of each task that fails. */
	std::function<void(const FSweepTask& Task, const std::vector<FDiagnostic>& Messages)> Report;
};

struct FShardResult
{
	int NumDone = 0;  // run now
	int NumThere = 0; // were there
	int NumFailed = 0;
};

/** The tasks of shard Index, from 1 on, of Count. Together all shards have each task once. */
DRYDOCK_API std::vector<size_t> ChooseShard(const FSweepPlan& Plan, int Index, int Count);

/** The tasks whose hashes begin with the texts. Throws FError (exit code 2) for a text that fits none or several. */
DRYDOCK_API std::vector<size_t> FindTasks(const FSweepPlan& Plan, const std::vector<std::string>& Hashes);

/** Runs the tasks here, those that are finished left out. A task that another process is at is waited for, and run where
 * that process ends without a result. A task that fails leaves its messages in the folder, and the others go on. Throws
 * FError where nothing of this can be done: no plan, a folder that cannot be written. */
DRYDOCK_API FShardResult RunShard(const FShardRequest& Request);

/** The same in a process of its own, which is started again where it crashed: the task that it was at has failed. */
DRYDOCK_API FShardResult RunShardApart(const FShardRequest& Request);

} // namespace Drydock
