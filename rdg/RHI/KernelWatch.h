// What becomes of a shader whose loop does not end: a GPU's driver takes the device away after two seconds, and a CPU
// would hang for good. Here the program says which shader it is and ends.
#pragma once

#include "CoreMinimal.h"

#include <atomic>
#include <string>

namespace Drydock
{

/** For its scope a kernel runs over tiles. Once no tile has ended for r.Drydock.ShaderSeconds (0: never), one message
 * DD6040 goes to stderr and the process ends with exit code 2: running kernels cannot be stopped in any other way. */
class DRYDOCK_API FKernelWatch
{
public:
	/** The names must outlive it. */
	FKernelWatch(const std::string& InShader, const std::string& InEntryPoint);
	~FKernelWatch();
	FKernelWatch(const FKernelWatch&) = delete;
	FKernelWatch& operator=(const FKernelWatch&) = delete;

	/** From any thread. */
	void TileHasEnded() { NumEnded.fetch_add(1, std::memory_order_relaxed); }

private:
	friend class FKernelWatcher;

	const std::string& Shader;
	const std::string& EntryPoint;
	const double Limit; // seconds; 0: none
	std::atomic<uint64> NumEnded{0};
	uint64 NumSeen = 0;       // of the watcher
	double SecondsSilent = 0; // since NumEnded became NumSeen
};

} // namespace Drydock
