// Turns settings objects into the settings a view renders with: the defaults, overriding by weight, and the final
// changes of console variables, show flags and view extensions. Source: engine
// FSceneView::StartFinalPostprocessSettings, OverridePostProcessSettings and EndFinalPostprocessSettings; the record of
// what was changed is drydock's.
#pragma once

#include "EngineProfile.h"
#include "PostProcessSettings.h"
#include "ShowFlags.h"

#include <string>
#include <vector>

namespace Drydock
{

class FBlendLedger;

/** A setting that a console variable, show flag or extension changed, and which one did. */
struct FSettingGate
{
	std::string Setting; // "BloomIntensity"
	std::string Reason;  // "ShowFlag.Bloom is off"
};

/** Defaults, with the values of r.DefaultFeature.* in this version of the engine. Overrides nothing. */
DRYDOCK_API FFinalPostProcessSettings StartFinalPostProcessSettings(
	FBlendLedger* Ledger = nullptr, const FEngineProfile& Engine = GetDefaultEngineProfile());

/** Blends every field that Source overrides into Settings, by the field's rule, and marks it overridden there. Weight
 * is clamped to 1; 0, less and NaN do nothing. Values that are not finite are left out. */
DRYDOCK_API void OverridePostProcessSettings(
	FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight);

/** Console variables and show flags have the last word. Returns what they changed; a value that was neutral already is
 * not listed. */
DRYDOCK_API std::vector<FSettingGate> EndFinalPostProcessSettings(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FBlendLedger* Ledger = nullptr);

/** The show flags' part of that alone, for flags that changed after the end: it may be repeated, which would add
 * r.ExposureOffset twice in the whole. */
DRYDOCK_API std::vector<FSettingGate> ApplyShowFlags(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FBlendLedger* Ledger = nullptr);

/** Records a view extension's changes of the settings in SetupView, after everything else. A value that is not finite
 * is put back. Returns the values that changed, and those that were put back. */
DRYDOCK_API std::vector<FSettingGate> RecordExtensionEdits(const FFinalPostProcessSettings& Before,
	FFinalPostProcessSettings& After, const std::string& Extension, FBlendLedger* Ledger = nullptr);

} // namespace Drydock
