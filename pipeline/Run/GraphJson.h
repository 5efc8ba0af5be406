// A compiled graph as JSON.
#pragma once

#include "RenderGraphCompiled.h"

#include <string>

namespace Drydock
{

/** {name, passes: [{index, name, scope, flags, culled, reason, shader, entry, effect, owner,
 * renderPassBegin, renderPassEnd, mergeReason, uses, producers}], resources,
 * transitions, memory}. Passes and resources refer to each other by index. */
DRYDOCK_API std::string MakeGraphJson(const FRDGCompiledGraph& Graph);

} // namespace Drydock
