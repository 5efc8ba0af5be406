// Warns of values that are valid, but that this build cannot act on.
#pragma once

#include "Config/Config.h"
#include "Effects/Effect.h"

namespace Drydock
{

/** Appends a warning for each such value. Console variables and texture loader must be those of the run. */
void WarnOfIneffectiveValues(const FConfig& Config, const FViewSettings& View, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
