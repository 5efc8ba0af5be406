// A run that is probed.
#pragma once

#include "Budget/RunOptions.h"
#include "Diagnostics.h"
#include "Inspect/ProbeCapture.h"

#include <vector>

namespace Drydock
{

struct FProbedRun
{
	std::vector<FProbePass> Passes;
	std::vector<FDiagnostic> Diagnostics; // of the run
};

/** Runs the config with a probe, and sets the request's frame. Throws FError: of the run; DD1020 where the region
 * leaves the frame, or no pass matches. */
DRYDOCK_API FProbedRun ProbeRun(const FRunOptions& Run, FProbeRequest& Request);

} // namespace Drydock
