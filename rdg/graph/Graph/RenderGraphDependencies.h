// First phase: finds which pass depends on which. Every subresource remembers its last writer on each pipeline; a pass
// that touches it, reading or writing, depends on them; a pass that writes becomes the last writer. So a write after a
// write keeps the earlier writer, and a write after a read makes no edge: passes are never reordered. Source: engine
// RenderGraphBuilder.cpp, restated.
#pragma once

#include "RenderGraphCompiled.h"

#include <array>

namespace Drydock
{

struct FRDGDependencies
{
	/** Last writer on each pipeline; -1: none. */
	using FWriters = std::array<int32_t, 2>;

	std::vector<std::vector<int32_t>> Producers; // by pass: ascending, each once
	std::vector<FWriters> Writers;               // by subresource, at the end of the graph
	std::vector<size_t> FirstSubresource; // by resource: of its subresources in Writers; one more behind the last

	/** Last writers of a resource's subresources, ascending, each once. */
	DRYDOCK_API std::vector<int32_t> GetLastWriters(size_t Resource) const;
};

DRYDOCK_API FRDGDependencies FindDependencies(const FRDGGraphDescription& Graph);

} // namespace Drydock
