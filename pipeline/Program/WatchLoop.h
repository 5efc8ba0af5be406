// Repeats an action whenever the files that it reads have changed, also when an edit leaves them broken for a second.
#pragma once

#include "Text/WatchedFiles.h"

#include <functional>

namespace Drydock
{

struct FWatchLoop
{
	std::function<void()> Run;           // what it throws is printed, and the loop goes on
	std::function<FWatchedFiles()> List; // the files as they are now; what it throws counts as no files
	std::function<bool()> Wait;          // between two looks; false ends the loop
};

/** Runs once, and again after each change. */
DRYDOCK_API void RunWatchLoop(const FWatchLoop& Loop);

} // namespace Drydock
