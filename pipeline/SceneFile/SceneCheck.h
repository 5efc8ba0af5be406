// Checks a config's scene and pictures by their headers, and reports all faults at once, before a frame is built.
#pragma once

#include "Config/Config.h"

namespace Drydock
{

class FImageFile;

/** The data of the scene that a verb needs. */
enum class ESceneNeed
{
	None,    // it is not looked at
	IfNamed, // it is checked where the config names one
	Required,
};

/** The message for a config without a scene. */
DRYDOCK_API FDiagnostic DescribeMissingScene(const FConfig& Config);

/** Channels that the config maps or gives a value to, and that no pass knows; where File is not null also those that
 * they are mapped to and that the file does not have. */
DRYDOCK_API void CheckSceneChannels(
	const FConfig& Config, const FImageFile* File, std::vector<FDiagnostic>& Diagnostics);

/** The scene: its file, its channels, and views that leave its picture. For a sequence whose frame is not chosen yet,
 * only the checks without a file run. */
DRYDOCK_API void CheckScene(const FConfig& Config, ESceneNeed Need, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
