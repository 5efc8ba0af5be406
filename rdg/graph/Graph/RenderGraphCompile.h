// The phases in their order: dependencies, cull, merge, async windows, lifetimes, alias, transitions. Pure: the same
// description and options give the same compiled graph. The order is the engine's.
#pragma once

#include "RenderGraphCompiled.h"

namespace Drydock
{

/** The console variables that the phases obey. */
struct FRDGCompileOptions
{
	bool bCullPasses = true;
	bool bMergeRenderPasses = true;
	bool bTransientHeap = true; // false: every resource has memory of its own
	bool bExtendLifetimes = false;
	bool bOverlapUAVs = true;

	/** From r.RDG.*. */
	static DRYDOCK_API FRDGCompileOptions FromConsoleVariables();
};

/** Takes the description over: move it where it is not needed any more. */
DRYDOCK_API FRDGCompiledGraph CompileGraph(FRDGGraphDescription Graph, const FRDGCompileOptions& Options);

} // namespace Drydock
