// SIGINT, SIGTERM and SIGHUP end the program and leave nothing behind.
#pragma once

#include "DrydockAPI.h"

namespace Drydock
{

/** Installs the handlers: these signals then do the end actions (EndAction.h), clear the line of a progress bar, and
 * end the process with exit code 128 + signal. A second one ends it at once. */
DRYDOCK_API void CatchEndingSignals();

} // namespace Drydock
