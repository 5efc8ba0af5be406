// Plugins: shared objects whose extensions, passes, shaders and console variables register themselves when they are
// loaded. One is loaded once in a process and stays; its extensions take part in the runs whose config names it. A
// file that has changed is loaded anew.
#pragma once

#include "Config/Config.h"
#include "Objects/ObjectValues.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FLoadedPlugins
{
	std::vector<std::string> Files;         // for FFrameInputs::Plugins
	std::vector<FIniVariable> IniVariables; // that their ini files set
};

/** Loads the plugins of Config.Plugins that are not loaded yet, gives their classes the values of their ini files and
 * of Config.Objects, and starts their modules. A plugin that does not exist or cannot be loaded is an error in
 * Diagnostics and left out; a doubtful one is a warning there. */
DRYDOCK_API FLoadedPlugins LoadPlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** Lines about names that the engine version of a library does not have: `drydock build` writes the file beside the
 * library where nobody named the version, and a run that loads the library warns of them. */
DRYDOCK_API std::string GetVersionNotesFile(const std::string& Library);

/** The ini files that a loaded plugin was given values from. Plugin: the path of its library. */
DRYDOCK_API std::vector<std::string> FindPluginIniFiles(const std::string& Plugin);

/** Replaces LoadPlugins for a config that is not trusted with code: each plugin that it names is an error. */
void RefusePlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
