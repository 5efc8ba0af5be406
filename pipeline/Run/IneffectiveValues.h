// Warns of values that are valid, but that this build cannot act on.
#pragma once

#include "Config/Config.h"
#include "Effects/Effect.h"
#include "SceneFile/SceneCamera.h"

namespace Drydock
{

/** Appends a warning for each such value. Console variables and texture loader must be those of the run. */
void WarnOfIneffectiveValues(const FConfig& Config, const FViewSettings& View, std::vector<FDiagnostic>& Diagnostics);

/** Appends a warning where temporal antialiasing runs and has nothing to average: one frame, or frames without jitter.
 */
void WarnOfIdleTemporalAA(const FConfig& Config, const std::optional<FSceneCamera>& Camera,
	const std::vector<FEffectDecision>& Effects, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
