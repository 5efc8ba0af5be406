// Blends the parts of a settings object that are not single values: a colour table, an ambient cubemap, blendables.
// Source: engine FSceneView::OverridePostProcessSettings and FinalPostProcessSettings.h.
#pragma once

#include "PostProcessSettings.h"

#include <string>

namespace Drydock
{

/** Adds what Source overrides of these to the lists of Settings. Weight: above 0, at most 1. The table by its intensity
 * (clamped to 0..1) times Weight; the cubemap by tint times intensity (where they are overridden) times Weight; a
 * blendable by its own weight (at most 1) times Weight. Contributions that are not finite are left out. */
DRYDOCK_API void BlendContributions(
	FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight);

/** "/Game/A.A 75 %, None 25 %". */
DRYDOCK_API std::string DescribeLUTs(const FFinalPostProcessSettings& Settings);

/** "/Game/Sky.Sky (0.5, 0.5, 0.5)", or "None". */
DRYDOCK_API std::string DescribeCubemaps(const FFinalPostProcessSettings& Settings);

} // namespace Drydock
