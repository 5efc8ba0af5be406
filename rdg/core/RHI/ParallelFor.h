// Runs indices 0..Count-1 in parallel: by oneTBB, or a plain std::thread pool that the thread sanitizer understands.
// Inner to TileExecutor.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

/** Runs Body(Index) for every index on at most NumThreads threads, the caller among them. Body must not throw. One call
 *  at a time; not from inside Body. */
void ParallelFor(int32 NumThreads, int32 Count, TFunctionRef<void(int32)> Body);

} // namespace Drydock
