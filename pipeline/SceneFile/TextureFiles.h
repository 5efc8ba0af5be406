// Loads textures from image files: turns a path that a config's settings name into pixels (TextureAssets.h).
#pragma once

#include "Config/Config.h"
#include "Screen/TextureAssets.h"

namespace Drydock
{

/** A path with an image's extension is a file, relative to the config; colours are read as linear light (PNG is
 * decoded), a single channel as grey. A .cube file is the table of ColorGradingLUT. Any other path names an engine
 * asset and has no pixels. The loader throws FError (exit code 3) for a file that is missing or broken. */
DRYDOCK_API FTextureLoader MakeTextureLoader(const FConfig& Config);

/** Appends to Diagnostics an error for each such file that a volume, the camera or --pp names and whose header cannot
 * be read, whether or not a pass would read it. */
DRYDOCK_API void CheckTextureFiles(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
