// The state changes a GPU would need barriers for. Adjacent states of a subresource that can be one are merged; what
// remains different, and every unordered access after another, becomes a transition that begins after the last pass
// before and ends before the first pass after. A CPU needs none: they are computed to be looked at. Source: engine
// RenderGraphBuilder.cpp, restated.
#pragma once

#include "RenderGraphCompiled.h"

namespace Drydock
{

struct FRDGTransitionOptions
{
	bool bOverlapUAVs = true;     // r.RDG.OverlapUAVs: views made with SkipBarrier need none between their uses
	std::vector<bool> bTransient; // by resource: starts as Discard
};

/** Finds transitions, ordered by EndPass, then resource, then subresource; boxes of equal transitions are joined when
 * they cover the whole resource. */
DRYDOCK_API std::vector<FRDGTransition> FindTransitions(
	const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled, const FRDGTransitionOptions& Options);

} // namespace Drydock
