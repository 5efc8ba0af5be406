// The files that a run reads, for those who run again whenever one of them changes.
#pragma once

#include "Budget/RunOptions.h"
#include "Text/WatchedFiles.h"

namespace Drydock
{

/** The config, its scene, plugins and overlays, and every shader file, as they are now. A config with mistakes names
 * no further files; it is watched itself. */
DRYDOCK_API FWatchedFiles FindRunFiles(const FRunOptions& Options);

/** All compiled shaders are forgotten, or where nothing but shader files was edited, those that read them. */
DRYDOCK_API void ForgetEdited(const FWatchedFiles& Before, const FWatchedFiles& After);

} // namespace Drydock
