// Finds when an async-compute pass may start and must be done, in graphics passes. On a CPU passes run one after the
// other; the windows are recorded, and resources live through them as on a GPU. Source: engine RenderGraphBuilder.cpp,
// restated.
#pragma once

#include "RenderGraphDependencies.h"

namespace Drydock
{

/** -1: not an async pass, or culled. */
struct FRDGAsyncWindow
{
	int32_t Fork = -1; // the latest graphics pass that has to be done before
	int32_t Join = -1; // the earliest graphics pass that has to wait for it
};

/** Finds the windows, by pass. Fork: the latest graphics producer, no earlier than the fork of the async pass before.
 * Join: the earliest surviving graphics consumer, no later than the join of the async pass after. */
DRYDOCK_API std::vector<FRDGAsyncWindow> FindAsyncWindows(
	const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies, const std::vector<bool>& bCulled);

} // namespace Drydock
