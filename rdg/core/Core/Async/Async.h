// AsyncTask: one thread plays all parts here, so a task runs where it is started, at once, and is over when the call
// returns. A task that starts itself until something has happened waits for the end of the frame. Source: engine
// Async/Async.h, Async/TaskGraphInterfaces.h.
#pragma once

#include "CoreTypes.h"
#include "Templates/Function.h"

#include <string>
#include <utility>

/** The threads that the engine knows. */
namespace ENamedThreads
{

enum Type : int32
{
	RHIThread,
	GameThread,
	ActualRenderingThread,
	AnyThread = 0xff,
	AnyNormalThreadNormalTask = AnyThread,
	AnyHiPriThreadNormalTask,
	AnyHiPriThreadHiPriTask,
	AnyBackgroundThreadNormalTask,
	AnyBackgroundHiPriTask,
};

} // namespace ENamedThreads

namespace Drydock
{

/** Runs a task at once, unless eight tasks have started each other already: then it waits for RunWaitingTasks. */
DRYDOCK_API void RunTask(TUniqueFunction<void()> Task);

/** Runs the waiting tasks, once each. A task that they start again waits for the next call. Each frame ends with it. */
DRYDOCK_API void RunWaitingTasks();

/** Forgets the waiting tasks of a plugin, by the file name of its shared object. */
DRYDOCK_API void ForgetTasksOf(const std::string& Plugin);

} // namespace Drydock

inline void AsyncTask(ENamedThreads::Type, TUniqueFunction<void()> Function)
{
	Drydock::RunTask(std::move(Function));
}
