// From settings objects to the settings a view renders with: overriding by weight, then the last word of console
// variables and show flags. Source: engine FSceneView::OverridePostProcessSettings and EndFinalPostprocessSettings; the
// record of what was switched off is drydock's.
#pragma once

#include "PostProcessSettings.h"
#include "ShowFlags.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A setting that a console variable or show flag changed, and which one did. */
struct FSettingGate
{
	std::string Setting; // "BloomIntensity"
	std::string Reason;  // "ShowFlag.Bloom is off"
};

/** Defaults, with what r.DefaultFeature.* says of them. Overrides nothing. */
DRYDOCK_API FFinalPostProcessSettings StartFinalPostProcessSettings();

/** Blends every field that Source overrides into Settings, by the field's rule, and marks it overridden there. Weight
 * is clamped to 1; 0, less and NaN do nothing. */
DRYDOCK_API void OverridePostProcessSettings(
	FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight);

/** Console variables and show flags have the last word. Returns what they changed; a value that was neutral already is
 * not listed. */
DRYDOCK_API std::vector<FSettingGate> EndFinalPostProcessSettings(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags);

} // namespace Drydock
