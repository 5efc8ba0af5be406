// Hands the shards of a sweep to what runs them: processes here, GNU parallel, or Slurm. Each is a script, which is
// left in the folder to be read and changed.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepFolder.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FSubmitRequest
{
	std::string Folder;
	std::string Engine = "local";     // GetSweepEngines
	int NumShards = 0;                // 0: ChooseShardCount
	std::vector<std::string> Options; // of parallel or sbatch
};

/** "local", "parallel", "slurm". */
DRYDOCK_API const std::vector<std::string>& GetSweepEngines();

/** Local as many as cores; else shards of ten minutes by the measured time, as far as that gives 16 at least and 1,000
 * at most; never more than tasks. */
DRYDOCK_API int ChooseShardCount(const FSweepPlan& Plan, const std::string& Engine);

/** A script by its name: that of the engine first. Program: drydock. Folder of the request: absolute. */
DRYDOCK_API std::vector<std::pair<std::string, std::string>> MakeSubmitScripts(
	const FSubmitRequest& Request, const std::string& Program, const std::string& Joblog);

/** Whether a joblog of parallel has a shard as done whose results are not all there: to resume by it would leave them
 * out.
 */
DRYDOCK_API bool IsJoblogStale(
	const std::string& Joblog, const FSweepFolder& Folder, const FSweepPlan& Plan, int NumShards);

/** Runs what is missing, or has Slurm run it and reduce it afterwards. Returns what the engine said. Throws FError
 * (DD1145, exit code 3) where the engine cannot be started, or refuses. */
DRYDOCK_API std::string SubmitSweep(const FSubmitRequest& Request);

} // namespace Drydock
