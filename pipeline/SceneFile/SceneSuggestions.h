// Reads the camera and the post-process volumes from a scene file's header: the attribute drydock:camera_json,
// described in configs/scenes/README.md.
#pragma once

#include "Config/Config.h"

namespace Drydock
{

/** Fills what the config leaves to its scene: the volumes if "volumes" is "fromScene", and the camera's location where
 * bounded volumes ask for one and the config has none. The header is read only for these. A suggested setting that does
 * not exist here is left out, with a warning; "fromScene" without a scene, or with one that suggests nothing, is an
 * error. Throws FError (exit code 3): a file that cannot be read. */
DRYDOCK_API void CompleteFromScene(FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** The volumes of a text as in the attribute; File names the scene in messages. */
DRYDOCK_API std::vector<FConfigVolume> ReadSuggestedVolumes(
	const std::string& CameraJson, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** The camera's location of such a text, cm; empty when it has none. */
DRYDOCK_API std::optional<FConfigVector> ReadSuggestedLocation(const std::string& CameraJson);

} // namespace Drydock
