// Handles crashes: one message that names the code at fault, and an exit code of its own. Installed by drydock's
// program; a program around the library keeps its own handlers.
#pragma once

#include "DrydockAPI.h"

namespace Drydock
{

/** Installs handlers. A fault (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT), std::terminate, and exit from inside
 * a plugin's code then end the process with one line on stderr: exit code 71 where the running code (RunningCode.h) is
 * a plugin's, else 70. A core file is left if core files are enabled. Does nothing in builds with a sanitizer, which
 * have handlers of their own. */
DRYDOCK_API void InstallFaultHandlers();

/** A fault is being reported, or its core file written: no other code has to end the process. */
DRYDOCK_API bool IsEndingByFault();

/** Gives this thread a stack for the handlers of its signals, once they are installed: without one, an overflow of its
 * own stack could not be reported. */
DRYDOCK_API void EnsureFaultStack();

} // namespace Drydock
