// Takes the folders of this machine out of a page, which people send on.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** The text with its absolute paths shortened: those below the working folder, drydock's own sources or its
 * installation become relative to it, of others the last part remains (".../scene.exr"). A path is absolute if its
 * first part is an entry of this machine's root folder, so that virtual paths of shaders stay. */
DRYDOCK_API std::string MakePathsPortable(const std::string& Text);

} // namespace Drydock
