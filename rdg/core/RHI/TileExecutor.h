// Runs a box of work as tiles on all threads. A tile must write only what no other tile reads or writes; then the
// result is the same bits for any number of threads and any order.
#pragma once

#include "CoreMinimal.h"
#include "ShaderKernel.h"

namespace Drydock
{

/** The processor's treatment of denormal numbers. */
enum class EDenormals : uint8
{
	Keep,  // double arithmetic
	Flush, // float arithmetic: denormal inputs and results are 0, as on GPUs
};

/** Sets the calling thread's denormal mode and puts the control word back. Does nothing on processors other than x86-64
 *  and AArch64. */
class DRYDOCK_API FScopedDenormals : private FNoncopyable
{
public:
	explicit FScopedDenormals(EDenormals Mode);
	~FScopedDenormals();

	/** The thread's whole floating-point control word. */
	static uint64 GetControlWord();

private:
	uint64 SavedControlWord;
};

/** Threads a run may use now: r.Drydock.Threads, or all of the machine's for 0. */
DRYDOCK_API int32 GetNumThreads();

/** Cuts Whole into tiles of TileSize (a component below 1: not cut that way), counted from Whole's minimum, and runs
 * Body on each, on the caller and the workers, under the given denormal mode. Returns when all are done. An exception
 * leaves from here once running tiles have ended: of those thrown, the one of the first tile in row-major order; tiles
 * after it may not have run. Inside a tile, a nested call runs on the calling thread. */
DRYDOCK_API void ForEachTile(const FKernelTile& Whole, FIntVector TileSize, TFunctionRef<void(const FKernelTile&)> Body,
	EDenormals Denormals = EDenormals::Keep);

/** One slice per tile in Z. */
DRYDOCK_API void ForEachTile(const FKernelTile& Whole, FIntPoint TileSize, TFunctionRef<void(const FKernelTile&)> Body,
	EDenormals Denormals = EDenormals::Keep);

} // namespace Drydock
