// Hands the shards of a sweep to what runs them: processes here, GNU parallel, or Slurm. Scripts are left in the folder, to
// be read and changed.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepExec.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

enum class ESweepEngine
{
	Local,
	Parallel,
	Slurm,
};

/** "local", "parallel", "slurm", in the order of ESweepEngine. */
DRYDOCK_API const std::vector<std::string>& GetSweepEngineNames();

struct FSubmitRequest
{
	std::string Folder;
	ESweepEngine Engine = ESweepEngine::Local;
	int NumShards = 0;                // 0: ChooseShardCount
	std::vector<std::string> Options; // of parallel or sbatch
	std::string Program;              // as of FShardRequest
};

struct FSubmitResult
{
	bool bWaited = true;               // false: Slurm has the shards, and what follows them
	std::string Said;                  // by the engine
	std::vector<std::string> Failures; // of shards
};

/** Shards for a plan: local as many as cores; for the others about ten minutes each by the measured cost, as far as that
 * gives 16 at least and 1,000 at most, and never more than tasks. */
DRYDOCK_API int ChooseShardCount(const FSweepPlan& Plan, ESweepEngine Engine);

/** parallel.sh. Log: the joblog. */
DRYDOCK_API std::string MakeParallelScript(
	const FSubmitRequest& Request, const std::string& Program, int NumShards, const std::string& Log);
/** slurm_array.sh, slurm_reduce.sh and slurm.sh, which submits both. */
DRYDOCK_API std::string MakeSlurmArrayScript(const FSubmitRequest& Request, const std::string& Program, int NumShards);
DRYDOCK_API std::string MakeSlurmReduceScript(const FSubmitRequest& Request, const std::string& Program);
DRYDOCK_API std::string MakeSlurmScript(const FSubmitRequest& Request);

/** Whether a joblog of parallel has a shard as done whose results are not all there: to resume by it would leave them out.
 */
DRYDOCK_API bool IsJoblogStale(
	const std::string& Joblog, const FSweepFolder& Folder, const FSweepPlan& Plan, int NumShards);

/** Runs what is missing, or has Slurm run it. Throws FError (DD1145, exit code 3) where the engine cannot be started, or
 * refuses. */
DRYDOCK_API FSubmitResult SubmitSweep(const FSubmitRequest& Request);

} // namespace Drydock
