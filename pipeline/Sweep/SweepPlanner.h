// Expands the sweep of a config into tasks.
#pragma once

#include "Config/ReadConfig.h"
#include "DrydockAPI.h"
#include "Sweep/SweepPlan.h"

#include <cstddef>
#include <vector>

namespace Drydock
{

/** The member "sweep" of a config. Throws FError (exit code 2) where it has none. */
DRYDOCK_API FJsonValue FindSweep(const FConfigDocument& Document);

/** The product of the axes' values: how many tasks there are at most, but for pieces. */
DRYDOCK_API size_t CountCombinations(const FJsonValue& Sweep);

/** The tasks of a config's sweep, with hashes, not measured. Remarks on axes that change nothing are appended to
 * Remarks. Plugins of the config must be loaded. Throws FError (exit code 2) with all mistakes of the sweep that can be
 * found, each at its place. */
DRYDOCK_API FSweepPlan PlanSweep(const FConfig& Config, const FJsonValue& Sweep, std::vector<FDiagnostic>& Remarks);

} // namespace Drydock
