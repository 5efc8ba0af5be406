// The tasks that one thread does for all others, one after the other.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

namespace Drydock
{

class FLiveQueue
{
public:
	/** From any other thread: has Function called by the thread of RunNext. Returns what it returns, and throws what it
	 * throws; std::future_error where the queue is closed. */
	template<typename TFunction>
	auto Call(TFunction Function)
	{
		auto Task = std::make_shared<std::packaged_task<decltype(Function())()>>(std::move(Function));
		auto Result = Task->get_future();
		Add([Task] { (*Task)(); });
		Task.reset(); // the queue alone holds it: where that is closed, the promise is broken
		return Result.get();
	}

	/** Does the next task; waits for one as long as Most. False: there was none. */
	bool RunNext(std::chrono::steady_clock::duration Most)
	{
		std::function<void()> Task;
		{
			std::unique_lock Lock(Mutex);
			if (!Added.wait_for(Lock, Most, [this] { return !Tasks.empty(); }))
			{
				return false;
			}
			Task = std::move(Tasks.front());
			Tasks.pop_front();
		}
		Task();
		return true;
	}

	/** Nothing is called any more; whoever waits gets the error. */
	void Close()
	{
		const std::lock_guard Lock(Mutex);
		bClosed = true;
		Tasks.clear();
	}

private:
	void Add(std::function<void()> Task)
	{
		const std::lock_guard Lock(Mutex);
		if (!bClosed)
		{
			Tasks.push_back(std::move(Task));
			Added.notify_one();
		}
	}

	std::mutex Mutex;
	std::condition_variable Added;
	std::deque<std::function<void()>> Tasks;
	bool bClosed = false;
};

} // namespace Drydock
