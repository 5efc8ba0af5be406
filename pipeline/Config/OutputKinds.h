// Chooses the outputs that a run writes: the config's outputs.write, --outputs, and the default of callers who ask for
// less.
#pragma once

#include "DrydockAPI.h"

#include <set>
#include <string>
#include <vector>

namespace Drydock
{

enum class EOutputKind
{
	Png,  // pictures to look at
	Exr,  // pictures to compute with
	Json, // timing.json and trace.json; run.json, which lists the files, is always written
	Dot,  // the graph
};

using FOutputKinds = std::set<EOutputKind>;

/** "png", "exr", ...: in the order of EOutputKind. */
DRYDOCK_API const std::vector<std::string>& GetOutputKindNames();

/** Makes the kinds from names that exist (GetOutputKindNames); others count for nothing. */
DRYDOCK_API FOutputKinds MakeOutputKinds(const std::vector<std::string>& Names);

DRYDOCK_API FOutputKinds GetAllOutputKinds();

} // namespace Drydock
