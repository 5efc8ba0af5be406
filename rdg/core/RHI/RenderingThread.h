// The render thread is the thread one is on: commands run where they are enqueued. Source: engine RenderingThread.h.
#pragma once

#include "CoreGlobals.h"
#include "RHICommandList.h"
#include "RenderCommandFence.h"

inline void FlushRenderingCommands() {}

namespace Drydock
{

/** The object that ENQUEUE_RENDER_COMMAND makes: runs the lambda it is given at once. */
struct FRenderCommandRunner
{
	template<typename TLambda>
	void operator()(TLambda&& Lambda) const
	{
		Lambda(FRHICommandListExecutor::GetImmediateCommandList());
	}
};

} // namespace Drydock

#define ENQUEUE_RENDER_COMMAND(Type) ::Drydock::FRenderCommandRunner()
