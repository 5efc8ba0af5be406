// Volumes between engine text and config. See configs/README.md.
#pragma once

#include "Config/Config.h"
#include "PostProcessSettingsTextVolume.h"
#include "Text/JsonWriter.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The value of a config's "volumes". Settings that are overridden, and others that are not at their defaults beside
 * `"bOverride_X": false`. */
DRYDOCK_API void WriteVolumes(FJsonWriter& Writer, const std::vector<FVolumeText>& Volumes);

/** A volume of a config. A shape that is not a box is left out, with a warning that names File. */
DRYDOCK_API FVolumeText MakeVolumeText(
	const FConfigVolume& Volume, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
