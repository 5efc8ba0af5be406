// A file as a string. Source: drydock.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** All its bytes. Throws FError (exit code 3) when it cannot be read. */
DRYDOCK_API std::string ReadTextFile(const std::string& Path);

} // namespace Drydock
