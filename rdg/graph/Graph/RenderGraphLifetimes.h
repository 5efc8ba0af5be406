// Finds the passes between which a resource has to be in memory: from the first surviving pass that touches it to the
// last, and as long as the window of an async pass that does. Source: engine RenderGraphBuilder.cpp, restated.
#pragma once

#include "RenderGraphAsyncCompute.h"

namespace Drydock
{

struct FRDGLifetime
{
	int32_t First = -1; // -1: no surviving pass touches it
	int32_t Last = -1;
	int32_t NumUses = 0;
	std::vector<int32_t> CulledUsers; // of an unused resource: the passes that would have used it
};

/** Finds lifetimes, by resource. bExtend (r.RDG.Debug.ExtendResourceLifetimes): used resources live for the whole
 * graph. */
DRYDOCK_API std::vector<FRDGLifetime> FindLifetimes(const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled,
	const std::vector<FRDGAsyncWindow>& AsyncWindows, bool bExtend);

} // namespace Drydock
