// Looks from a thread of its own at the kernels that run, and ends the program when one does not end.
#include "KernelWatch.h"

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformTime.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

static TAutoConsoleVariable<float> CVarDrydockShaderSeconds(TEXT("r.Drydock.ShaderSeconds"), 300.0f,
	TEXT("A shader of which no tile ends for this many seconds ends the program with a message: its loop has no end.\n")
		TEXT(" 0: it may take as long as it likes"));

namespace Drydock
{

/** Looks at all running kernels from a thread of its own, which is there from the first kernel on. */
class FKernelWatcher
{
public:
	static FKernelWatcher& Get()
	{
		static FKernelWatcher Watcher;
		return Watcher;
	}

	void Add(FKernelWatch& Watch)
	{
		const std::lock_guard Lock(Mutex);
		Watches.push_back(&Watch);
		if (!Thread.joinable())
		{
			Thread = std::thread([this] { Run(); });
		}
		if (std::exchange(bAsleep, false)) // a wake for each of many short kernels would cost more than they do
		{
			Wake.notify_one();
		}
	}

	void Remove(FKernelWatch& Watch)
	{
		const std::lock_guard Lock(Mutex);
		Watches.erase(std::find(Watches.begin(), Watches.end(), &Watch));
	}

private:
	FKernelWatcher() = default;
	~FKernelWatcher()
	{
		{
			const std::lock_guard Lock(Mutex);
			bEnds = true;
		}
		Wake.notify_one();
		if (Thread.joinable())
		{
			Thread.join();
		}
	}

	void Run()
	{
		std::unique_lock Lock(Mutex);
		while (!bEnds)
		{
			const double Now = FPlatformTime::Seconds();
			const double Passed = std::min(Now - LastLook, LongestLook);
			LastLook = Now;
			for (FKernelWatch* Watch : Watches)
			{
				Look(*Watch, Passed);
			}
			bAsleep = Watches.empty();
			if (bAsleep)
			{
				Wake.wait(Lock, [this] { return bEnds || !bAsleep; });
				LastLook = FPlatformTime::Seconds();
			}
			else
			{
				Wake.wait_for(Lock, std::chrono::milliseconds(250), [this] { return bEnds; });
			}
		}
	}

	static void Look(FKernelWatch& Watch, double Passed)
	{
		const uint64 NumEnded = Watch.NumEnded.load(std::memory_order_relaxed);
		if (NumEnded != Watch.NumSeen)
		{
			Watch.NumSeen = NumEnded;
			Watch.SecondsSilent = 0;
			return;
		}
		Watch.SecondsSilent += Passed;
		if (Watch.SecondsSilent < Watch.Limit)
		{
			return;
		}
		char Limit[32];
		std::snprintf(Limit, sizeof(Limit), "%g", Watch.Limit);
		const FDiagnostic Diagnostic = {ESeverity::Error, 6040,
			"shader " + Watch.Shader + " (entry point '" + Watch.EntryPoint + "') has not ended one tile for " + Limit +
				" s: does each of its loops have an end? (r.Drydock.ShaderSeconds)",
			{}, 0, 0, {}};
		std::fprintf(stderr, "%s\n", Diagnostic.ToString().c_str());
		std::fflush(nullptr);
		std::_Exit(ExitUsage);
	}

	/** A process that was stopped for a while (a debugger, a terminal's Ctrl+Z) has not hung for all of it. */
	static constexpr double LongestLook = 1.0;

	std::mutex Mutex;
	std::condition_variable Wake;
	std::vector<FKernelWatch*> Watches;
	std::thread Thread;
	double LastLook = FPlatformTime::Seconds();
	bool bEnds = false;
	bool bAsleep = false; // until a kernel comes
};

FKernelWatch::FKernelWatch(const std::string& InShader, const std::string& InEntryPoint)
	: Shader(InShader)
	, EntryPoint(InEntryPoint)
	, Limit(CVarDrydockShaderSeconds.GetValueOnAnyThread())
{
	if (Limit > 0.0)
	{
		FKernelWatcher::Get().Add(*this);
	}
}

FKernelWatch::~FKernelWatch()
{
	if (Limit > 0.0)
	{
		FKernelWatcher::Get().Remove(*this);
	}
}

} // namespace Drydock
