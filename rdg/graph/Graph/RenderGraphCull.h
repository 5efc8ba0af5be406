// Culls passes that nothing needs. Every pass starts culled; roots and, from them, all producers are kept. Roots are
// the sentinels, passes that must not be culled (NeverCull, no parameters, writes outside the graph) and the last
// writers of extracted and external resources. Source: engine RenderGraphBuilder.cpp, restated; the chains of readers
// are drydock's.
#pragma once

#include "RenderGraphDependencies.h"

namespace Drydock
{

struct FRDGCullResult
{
	std::vector<bool> bCulled;           // by pass
	std::vector<FRDGCulledChain> Chains; // by pass
};

/** bEnabled false (r.RDG.CullPasses 0, immediate mode): nothing is culled. */
DRYDOCK_API FRDGCullResult CullPasses(
	const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies, bool bEnabled);

} // namespace Drydock
