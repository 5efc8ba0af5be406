// Runs ParallelFor on threads of std::thread.
#if !DRYDOCK_EXECUTOR_TBB

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "ParallelFor.h"

namespace Drydock
{

namespace
{

/** Workers sleep between jobs; within a job everyone takes the next index until none is left. */
class FThreadPool
{
public:
	explicit FThreadPool(int32 InNumThreads)
		: NumThreads(InNumThreads)
	{
		for (int32 Worker = 1; Worker < NumThreads; ++Worker)
		{
			Workers.emplace_back([this] { Work(); });
		}
	}

	~FThreadPool()
	{
		{
			std::lock_guard Lock(Mutex);
			bStop = true;
		}
		JobPosted.notify_all();
		for (std::thread& Worker : Workers)
		{
			Worker.join();
		}
	}

	int32 GetNumThreads() const { return NumThreads; }

	void Run(int32 Count, TFunctionRef<void(int32)> Body)
	{
		{
			std::lock_guard Lock(Mutex);
			Job = &Body;
			JobCount = Count;
			NextIndex = 0;
			NumBusy = int32(Workers.size());
			++JobNumber;
		}
		JobPosted.notify_all();
		TakeIndices(Body, Count);
		std::unique_lock Lock(Mutex);
		JobDone.wait(Lock, [this] { return NumBusy == 0; });
	}

private:
	void TakeIndices(TFunctionRef<void(int32)> Body, int32 Count)
	{
		for (int32 Index = NextIndex++; Index < Count; Index = NextIndex++)
		{
			Body(Index);
		}
	}

	void Work()
	{
		uint64 LastJob = 0;
		std::unique_lock Lock(Mutex);
		for (;;)
		{
			JobPosted.wait(Lock, [&] { return bStop || JobNumber != LastJob; });
			if (bStop)
			{
				return;
			}
			LastJob = JobNumber;
			const TFunctionRef<void(int32)> Body = *Job;
			const int32 Count = JobCount;
			Lock.unlock();
			TakeIndices(Body, Count);
			Lock.lock();
			if (--NumBusy == 0)
			{
				JobDone.notify_one();
			}
		}
	}

	const int32 NumThreads;
	std::vector<std::thread> Workers;
	std::mutex Mutex;
	std::condition_variable JobPosted;
	std::condition_variable JobDone;
	const TFunctionRef<void(int32)>* Job = nullptr;
	int32 JobCount = 0;
	std::atomic<int32> NextIndex{0};
	int32 NumBusy = 0; // workers that have not finished the current job
	uint64 JobNumber = 0;
	bool bStop = false;
};

} // namespace

void ParallelFor(int32 NumThreads, int32 Count, TFunctionRef<void(int32)> Body)
{
	static std::unique_ptr<FThreadPool> Pool;
	if (!Pool || Pool->GetNumThreads() != NumThreads)
	{
		Pool.reset();
		Pool = std::make_unique<FThreadPool>(NumThreads);
	}
	Pool->Run(Count, Body);
}

} // namespace Drydock

#endif
