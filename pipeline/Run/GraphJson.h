// A compiled graph as JSON.
#pragma once

#include "RenderGraphCompiled.h"
#include "Run/PassValues.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** {name, passes: [{index, name, scope, flags, culled, reason, shader, entry, effect, owner, renderPassBegin,
 * renderPassEnd, mergeReason, values, uses, producers}], resources, transitions, memory}. Passes and resources refer to
 * each other by index. mergeReason: why a raster pass begins a render pass of its own. Values: of passes, by index. */
DRYDOCK_API std::string MakeGraphJson(
	const FRDGCompiledGraph& Graph, const std::map<int, std::vector<FPassValue>>& Values = {});

} // namespace Drydock
