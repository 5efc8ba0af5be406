// Plugins: shared objects whose extensions, passes, shaders and console variables register themselves when they are
// loaded. One is loaded once in a process and stays; its extensions take part in the runs whose config names it. A
// file that has changed is loaded anew.
#pragma once

#include "Config/Config.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Loads what Config.Plugins names and is not loaded yet, and starts its modules. Returns the files, for
 * FFrameInputs::Plugins. What does not exist or cannot be loaded is an error in Diagnostics and left out; what is
 * doubtful is a warning there. */
DRYDOCK_API std::vector<std::string> LoadPlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** In place of that, for a config that is not trusted with code: each plugin that it names is an error. */
void RefusePlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
