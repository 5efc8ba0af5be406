// Names the parts of engine overlays that a frame did not use: functions and blocks that the chain did not call,
// shaders in no pass.
#pragma once

#include "Overlay/OverlayFolder.h"
#include "Run/RunResult.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A note for each, with the chain's reason. Uncalled: names of replacements that were not called
 * (TakeUncalledReplacements). The shaders of a frame that did not run are not known, and not named. */
std::vector<FDiagnostic> FindUnusedOfOverlays(
	const std::vector<FOverlayFolder>& Folders, const std::vector<std::string>& Uncalled, const FRunResult& Result);

} // namespace Drydock
