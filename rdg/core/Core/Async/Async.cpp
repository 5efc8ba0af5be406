// Runs tasks where they are started, and keeps those that start each other without end until the frame is over.
#include "Async/Async.h"

#include "CodeScope.h"
#include "Templates/UnrealTemplate.h"

#include <utility>
#include <vector>

namespace Drydock
{

namespace
{

constexpr int32 MaxDepth = 8;

thread_local int32 GDepth = 0;

struct FWaitingTask
{
	TUniqueFunction<void()> Task;
	FCodeOwner Owner;
};

/** Never destroyed: static variables of any library end later. */
std::vector<FWaitingTask>& GetWaiting()
{
	static auto* const Waiting = new std::vector<FWaitingTask>;
	return *Waiting;
}

} // namespace

void RunTask(TUniqueFunction<void()> Task)
{
	if (GDepth == MaxDepth)
	{
		GetWaiting().push_back({std::move(Task), MakeCodeOwner("a task of AsyncTask")});
		return;
	}
	const TGuardValue<int32> Deeper(GDepth, GDepth + 1);
	Task();
}

void RunWaitingTasks()
{
	for (const FWaitingTask& Waiting : std::exchange(GetWaiting(), {}))
	{
		// It has waited once: what it starts again waits for the next frame.
		const TGuardValue<int32> Deepest(GDepth, MaxDepth);
		CallCode(Waiting.Owner, [&] { Waiting.Task(); });
	}
}

void ForgetTasksOf(const std::string& Plugin)
{
	std::erase_if(GetWaiting(), [&](const FWaitingTask& Waiting) { return Waiting.Owner.Plugin == Plugin; });
}

} // namespace Drydock
