// Finds the raster passes that a GPU would run as one render pass: surviving neighbours with the same targets, where
// the later one does not clear. A CPU runs them one by one with the same result; the decision and its reason are
// recorded. Source: engine RenderGraphBuilder.cpp, restated; the reasons are drydock's.
#pragma once

#include "RenderGraphCompiled.h"

namespace Drydock
{

struct FRDGRenderPass
{
	int32_t Begin = -1; // first and last pass merged together; -1: not a raster pass, or culled
	int32_t End = -1;
	std::string Reason; // why it was not merged into the raster pass before; empty for merged ones
};

/** Finds the merged render passes, by pass. bEnabled: r.RDG.MergeRenderPasses. */
DRYDOCK_API std::vector<FRDGRenderPass> MergeRenderPasses(
	const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled, bool bEnabled);

} // namespace Drydock
