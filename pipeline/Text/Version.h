// The version of drydock, as --version prints it and outputs record it.
#pragma once

#include "DrydockAPI.h"

namespace Drydock
{

/** The program's version. */
DRYDOCK_API const char* GetVersion();

/** The commit that the program was built from, twelve digits; empty where the sources are not a checkout of git. */
DRYDOCK_API const char* GetCommit();

} // namespace Drydock
