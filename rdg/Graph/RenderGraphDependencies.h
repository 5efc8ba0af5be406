// First phase: who depends on whom. Every subresource remembers its last writer on each pipeline; a pass that touches
// it, reading or writing, depends on them; a pass that writes becomes the last writer. So a write after a write keeps
// the earlier writer, and a write after a read makes no edge: passes are never reordered. Source: engine
// RenderGraphBuilder.cpp, restated.
#pragma once

#include "RenderGraphCompiled.h"

namespace Drydock
{

struct FRDGDependencies
{
	std::vector<std::vector<int32_t>> Producers; // by pass: ascending, each once
	std::vector<std::vector<int32_t>>
		LastWriters; // by resource: last writers of its subresources, ascending, each once
};

DRYDOCK_API FRDGDependencies FindDependencies(const FRDGGraphDescription& Graph);

} // namespace Drydock
