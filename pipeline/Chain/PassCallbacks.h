// Calls one callback of a view extension and holds it to its contract: return the picture with its rect, and draw to
// OverrideOutput where that is given. A callback that breaks it is reported and the picture goes on untouched; with
// r.RDG.Validation 2 the run stops. The contract is the engine's.
#pragma once

#include "Extensions/ViewExtensions.h"
#include "PostProcess/PostProcessMaterialInputs.h"

namespace Drydock
{

/** Runs Callback with Inputs, whose SceneColor slot is the picture so far. Point: its name in the log.
 * bLinear: what the callback returns is light before the tonemapper. Returns the picture from then on; where
 * OverrideOutput is valid, that one. Throws FError with r.RDG.Validation 2. */
FScreenPassTexture RunPassCallback(FRDGBuilder& GraphBuilder, const FNamedView& View, const std::string& Point,
	const FPassCallback& Callback, const FPostProcessMaterialInputs& Inputs, bool bLinear, FHookLog& Log);

} // namespace Drydock
