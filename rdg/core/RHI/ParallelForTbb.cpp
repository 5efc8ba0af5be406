// Runs ParallelFor on a oneTBB arena.
#if DRYDOCK_EXECUTOR_TBB

// oneTBB comes before CoreMinimal.h, whose check macro its headers would not survive.
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "ParallelFor.h"

namespace Drydock
{

void ParallelFor(int32 NumThreads, int32 Count, TFunctionRef<void(int32)> Body)
{
	// Making an arena is not free; runs keep their thread count for many dispatches. The limit lets a run have more
	// threads than the machine has cores, which is how tests find races.
	static std::unique_ptr<tbb::global_control> Limit;
	static std::unique_ptr<tbb::task_arena> Arena;
	if (!Arena || Arena->max_concurrency() != NumThreads)
	{
		Arena.reset();
		Limit.reset();
		Limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, size_t(NumThreads));
		Arena = std::make_unique<tbb::task_arena>(NumThreads);
	}
	Arena->execute([&] { tbb::parallel_for(int32(0), Count, [&](int32 Index) { Body(Index); }); });
}

} // namespace Drydock

#endif
