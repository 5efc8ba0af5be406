// The two files that an import leaves: the scene, and a config beside it that runs.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportConvert.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Writes the scene aside and puts it in place. bForce: also over what import did not write. Throws FError (exit code
 * 3). */
DRYDOCK_API void WriteImportedScene(const std::string& Path, const FImportScene& Scene, bool bForce);

/** Whether a file that stands there may be replaced: an EXR that import wrote. Throws FError (exit code 3) otherwise.
 */
DRYDOCK_API void CheckImportTarget(const std::string& Path, const std::vector<std::string>& Inputs, bool bForce);

/** Channels that many effects read and the scene lacks. */
DRYDOCK_API std::vector<std::string> FindMissingChannels(const FImportScene& Scene);

/** The schema that the config names, written beside it. */
inline constexpr const char* ImportSchemaName = "drydock.schema.json";

/** A config of toon bloom on the scene; SceneFile: as it is named in the config. */
DRYDOCK_API std::string MakeImportConfig(
	const std::string& SceneFile, const FImportScene& Scene, const std::vector<std::string>& Inputs);

/** The config's place: beside the scene, with .json for its end; of a sequence without the row of #. */
DRYDOCK_API std::string GetImportConfigPath(const std::string& SceneFile);

} // namespace Drydock
