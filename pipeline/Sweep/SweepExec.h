// Runs a shard: tasks of a plan, in this process or in one that is watched. A crash costs the one task that made it.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepPlan.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FShardRequest
{
	std::string Folder;
	std::vector<std::string> Hashes; // beginnings of hashes of tasks; empty: the shard's
	int Index = 1;                   // of the shard, from 1 on
	int Of = 1;                      // shards, which together have each task once
	std::optional<int> Threads;
};

struct FShardResult
{
	int NumDone = 0;                   // run now
	int NumThere = 0;                  // were there
	std::vector<std::string> Failures; // of each task that failed its values and its messages
};

/** The tasks of a shard by their indices. Throws FError (exit code 2): no such shard, or a text that fits no task. */
DRYDOCK_API std::vector<size_t> ChooseTasks(const FSweepPlan& Plan, const FShardRequest& Request);

/** Runs the tasks here but for those that are finished. One that another process is at is waited for, and run where
 * that process ends without a result. A task that fails leaves its messages in the folder, and the others go on. Throws
 * FError where nothing of this can be done. */
DRYDOCK_API FShardResult RunShard(const FShardRequest& Request);

/** The same in a process of its own, which is started again where it crashed: the task that it was at has failed. */
DRYDOCK_API FShardResult RunShardApart(const FShardRequest& Request);

} // namespace Drydock
