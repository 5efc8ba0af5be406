// A compiled graph as text for people and as a picture for dot. The same graph gives the same text.
#pragma once

#include "RenderGraphCompiled.h"

#include <map>
#include <string>

namespace Drydock
{

/** Passes, resources, what was culled and why, memory: what `drydock graph` prints. ValuesByPass: a line more for a
 * pass, by its index. */
DRYDOCK_API std::string DumpText(const FRDGCompiledGraph& Graph, const std::map<int, std::string>& ValuesByPass = {});

/** Graphviz: passes as boxes, resources as ellipses, edges for writes and reads; culled ones grey and dashed. */
DRYDOCK_API std::string DumpDot(const FRDGCompiledGraph& Graph);

/** One line per transition. */
DRYDOCK_API std::string DumpTransitions(const FRDGCompiledGraph& Graph);

/** "PF_FloatRGBA 1920x1080", "buffer 64 x 16 B". */
DRYDOCK_API std::string DescribeResource(const FRDGResourceDescription& Resource);

/** "1.50 MiB", "640 B". */
DRYDOCK_API std::string DescribeBytes(uint64_t Bytes);

/** "Raster|NeverCull". */
DRYDOCK_API std::string DescribePassFlags(ERDGPassFlags Flags);

} // namespace Drydock
