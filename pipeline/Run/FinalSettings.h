// The settings of a run: defaults, volumes, camera, command line, then console variables and show flags. The order is
// the engine's.
#pragma once

#include "BlendSettings.h"
#include "Config/Config.h"
#include "Effects/Effect.h"

namespace Drydock
{

/** Makes the blender of a config's settings at any location; for many locations, make it once. Console variables must
 * be set already, whenever it is asked. */
DRYDOCK_API FSettingsBlender MakeSettingsBlender(const FConfig& Config);

/** A config's settings at a location, cm; with the story of each in Ledger, unless that is null. Console variables must
 * be set already. */
DRYDOCK_API FBlendedSettings BlendSettingsAt(
	const FConfig& Config, const FVector& Location, FBlendLedger* Ledger = nullptr);

/** The camera's location, cm: of the config, else of the scene (see CompleteFromScene), else the origin. */
DRYDOCK_API FVector GetViewLocation(const FConfig& Config);

/** Blends the settings at the view's location. Console variables must be set already. Doubts about the blend (two
 * volumes of one priority that disagree, values that are not finite) are appended to Diagnostics, unless that is null.
 */
DRYDOCK_API FViewSettings MakeViewSettings(const FConfig& Config, std::vector<FDiagnostic>* Diagnostics = nullptr);

/** Names of all settings that something in the config gives, active or not. */
DRYDOCK_API std::vector<std::string> GetNamedSettings(const FConfig& Config);

/** A warning for each setting that the config gives and no effect reads, or that does nothing here. */
DRYDOCK_API void WarnOfUnreadSettings(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** "Stage"; "volumes/2" for one without a name. */
DRYDOCK_API std::string GetVolumeName(const FConfig& Config, size_t Index);

} // namespace Drydock
