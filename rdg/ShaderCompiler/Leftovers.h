// What a process writes aside bears its number, so that a later one can remove what a killed one has left behind.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** "drydock-4711-" for process 4711: how the names of its temporary files and folders begin. */
DRYDOCK_API std::string GetLeftoverPrefix();

/** Removes the user's files and folders of such names in Folder whose process is dead. What cannot be removed stays. */
DRYDOCK_API void RemoveLeftovers(const std::string& Folder);

} // namespace Drydock
