// Distinguishes a compiler that found a fault in its input from one that the machine kept from its work.
#pragma once

#include "ChildProcess.h"
#include "TemporaryFolder.h"

namespace Drydock
{

/** The machine's fault behind a tool's failure, as the end of a sentence: "was killed by signal 9 (out of memory?)",
 * "could not be started: Resource temporarily unavailable", "ended with: No space left on device". Empty: nothing, it
 * failed by itself. A compiler's driver reports the signal that killed the program it called; its messages are read as
 * English. */
DRYDOCK_API std::string FindToolFault(const FChildResult& Child);

/** "signal 9 (out of memory?)", "signal 15 (Terminated)". */
DRYDOCK_API std::string DescribeSignal(int Signal);

/** Whether a signal comes from outside (an operator, a limit, the kernel short of memory) and not from a fault of the
 * program that it ends. */
DRYDOCK_API bool IsSignalFromOutside(int Signal);

/** Environment of a tool: its messages in English, its temporary files below Folder, which goes with all that a killed
 * one leaves there. */
DRYDOCK_API std::vector<std::string> MakeToolEnvironment(const FTemporaryFolder& Folder);

} // namespace Drydock
