// The bar that the verbs of a sweep show while other processes run its tasks.
#pragma once

#include "Sweep/SweepFolder.h"

#include <chrono>
#include <functional>
#include <future>

namespace Drydock
{

/** Shows how many results are there until IsOver, which waits a moment each time. */
void ShowSweepBar(const FSweepFolder& Folder, const FSweepPlan& Plan, const std::function<bool()>& IsOver);

/** The result of Work, which runs on a thread of its own while the bar is shown; throws what it throws. */
template<typename TWork>
auto CallWithSweepBar(const FSweepFolder& Folder, const FSweepPlan& Plan, const TWork& Work)
{
	auto Done = std::async(std::launch::async, Work);
	ShowSweepBar(Folder, Plan,
		[&] { return Done.wait_for(std::chrono::milliseconds(300)) == std::future_status::ready; });
	return Done.get();
}

} // namespace Drydock
