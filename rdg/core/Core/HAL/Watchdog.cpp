// Looks from a thread of its own at all that is watched.
#include "HAL/Watchdog.h"

#include "HAL/PlatformTime.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace Drydock
{

/** Its thread is there from the first watchdog on. Never destroyed: libraries shut down at the very end of the program.
 */
class FWatcher
{
public:
	static FWatcher& Get()
	{
		static auto* const Watcher = new FWatcher;
		return *Watcher;
	}

	void Add(FWatchdog& Watch)
	{
		const std::lock_guard Lock(Mutex);
		Watches.push_back(&Watch);
		if (!std::exchange(bRuns, true))
		{
			std::thread([this] { Run(); }).detach();
		}
		if (std::exchange(bAsleep, false)) // a wake for each of many short ones would cost more than they do
		{
			Wake.notify_one();
		}
	}

	void Remove(FWatchdog& Watch)
	{
		const std::lock_guard Lock(Mutex);
		Watches.erase(std::find(Watches.begin(), Watches.end(), &Watch));
	}

private:
	FWatcher() = default;

	void Run()
	{
		std::unique_lock Lock(Mutex);
		for (;;)
		{
			const double Now = FPlatformTime::Seconds();
			const double Passed = std::min(Now - LastLook, LongestLook);
			LastLook = Now;
			for (FWatchdog* Watch : Watches)
			{
				Look(*Watch, Passed);
			}
			bAsleep = Watches.empty();
			if (bAsleep)
			{
				Wake.wait(Lock, [this] { return !bAsleep; });
				LastLook = FPlatformTime::Seconds();
			}
			else
			{
				Wake.wait_for(Lock, std::chrono::milliseconds(250));
			}
		}
	}

	static void Look(FWatchdog& Watch, double Passed)
	{
		const uint64 NumSigns = Watch.NumSigns.load(std::memory_order_relaxed);
		if (NumSigns != Watch.NumSeen || Watch.NumSuspended.load(std::memory_order_relaxed) > 0)
		{
			Watch.NumSeen = NumSigns;
			Watch.SecondsSilent = 0;
			return;
		}
		Watch.SecondsSilent += Passed;
		if (Watch.SecondsSilent >= Watch.Limit)
		{
			Watch.Report();
		}
	}

	/** A process that was stopped for a while (a debugger, a terminal's Ctrl+Z) has not hung for all of it. */
	static constexpr double LongestLook = 1.0;

	std::mutex Mutex;
	std::condition_variable Wake;
	std::vector<FWatchdog*> Watches;
	double LastLook = FPlatformTime::Seconds();
	bool bRuns = false;
	bool bAsleep = false; // until something is watched
};

FWatchdog::FWatchdog(double InLimit, std::function<void()> InReport)
	: Limit(InLimit)
	, Report(std::move(InReport))
{
	FWatcher::Get().Add(*this);
}

FWatchdog::~FWatchdog()
{
	FWatcher::Get().Remove(*this);
}

} // namespace Drydock
