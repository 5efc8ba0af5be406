// AsyncTask: one thread plays all parts here, so a task runs where it is started, at once, and is over when
// the call returns. Source: engine Async/Async.h, Async/TaskGraphInterfaces.h.
#pragma once

#include "CoreTypes.h"

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

template<typename FunctionType>
void AsyncTask(ENamedThreads::Type, FunctionType&& Function)
{
	std::forward<FunctionType>(Function)();
}
