// Finds which shader files are read: by the registered shader classes, and by a config's passes.
#pragma once

#include "Config/Config.h"
#include "DrydockAPI.h"

#include <set>
#include <string>

namespace Drydock
{

/** The file and all that it includes, on whatever condition: virtual paths in lower case. */
DRYDOCK_API std::set<std::string> ListIncludedShaders(const std::string& VirtualPath);

/** Those of every registered shader class, and of every shader that a pass of the config names. */
DRYDOCK_API std::set<std::string> ListReadShaders(const FConfig& Config);

} // namespace Drydock
