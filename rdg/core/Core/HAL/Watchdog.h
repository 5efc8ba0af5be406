// Watches code that must not stay silent for too long: a shader's tiles, a plugin's function. One thread looks at all.
#pragma once

#include "CoreTypes.h"
#include "Templates/UnrealTemplate.h"

#include <atomic>
#include <functional>

namespace Drydock
{

/** Watches code during its scope: once no sign of life has come for Limit seconds, Report is called from another
 * thread, and ends the process, unless something else does. */
class DRYDOCK_API FWatchdog : private FNoncopyable
{
public:
	FWatchdog(double InLimit, std::function<void()> InReport);
	~FWatchdog();

	/** From any thread. */
	void IsAlive() { NumSigns.fetch_add(1, std::memory_order_relaxed); }

	/** Silence is not a fault while suspended; calls nest. */
	void Suspend() { NumSuspended.fetch_add(1, std::memory_order_relaxed); }
	void Resume()
	{
		IsAlive();
		NumSuspended.fetch_sub(1, std::memory_order_relaxed);
	}

private:
	friend class FWatcher;

	const double Limit; // seconds
	const std::function<void()> Report;
	std::atomic<uint64> NumSigns{0};
	std::atomic<int32> NumSuspended{0};
	uint64 NumSeen = 0;       // of the watcher
	double SecondsSilent = 0; // since NumSigns became NumSeen
};

} // namespace Drydock
