// Threads as render code sees them: there is one, which is the game thread, the render thread and the RHI thread. Render
// commands run at once. Source: engine RenderingThread.h, HAL/ThreadManager (CoreGlobals.h).
#pragma once

#include "CoreGlobals.h"

#include <utility>

class FRHICommandListImmediate;

/** The command list that render commands receive; the RHI defines it. */
DRYDOCK_API FRHICommandListImmediate& GetImmediateCommandList_ForRenderCommand();

namespace Drydock
{

/** Runs what follows the macro. */
struct FRenderCommandRunner
{
	template <typename LambdaType>
	void operator()(LambdaType&& Lambda) const
	{
		Lambda(GetImmediateCommandList_ForRenderCommand());
	}
};

} // namespace Drydock

/** `ENQUEUE_RENDER_COMMAND(Name)([...](FRHICommandListImmediate& RHICmdList) { ... });` */
#define ENQUEUE_RENDER_COMMAND(Type) ::Drydock::FRenderCommandRunner()

/** Everything submitted is done already. */
inline void FlushRenderingCommands() {}
