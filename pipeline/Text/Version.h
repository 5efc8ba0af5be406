// The version of drydock, as --version prints it and outputs record it.
#pragma once

#include "DrydockAPI.h"

namespace Drydock
{

/** The program's version. */
DRYDOCK_API const char* GetVersion();

} // namespace Drydock
