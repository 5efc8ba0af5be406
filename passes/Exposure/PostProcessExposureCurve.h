// The exposure curve (AutoExposureBiasCurve) of a frame that has no frame before it. The engine evaluates the curve at
// the last frame's average luminance, and a first frame is exposed without it; here a single frame counts as converged,
// so its own luminance takes the last one's place. drydock.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphFwd.h"

class FRDGBuilder;
struct FFinalPostProcessSettings;

namespace Drydock
{

/** Metered: a buffer of PostProcessEyeAdaptation.h that snapped to its target with ExposureCompensationCurve 1. Returns
 * what it would be with the curve at its own average luminance: both scales and the compensation times that. Without
 * keys the same buffer. */
DRYDOCK_API FRDGBufferRef AddExposureCurvePass(
	FRDGBuilder& GraphBuilder, const FFinalPostProcessSettings& Settings, FRDGBufferRef Metered);

} // namespace Drydock
