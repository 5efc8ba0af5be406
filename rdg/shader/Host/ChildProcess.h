// Runs a program to its end on POSIX: argument vector, no shell, time limit.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FChildResult
{
	bool bStarted = false;
	int StartError = 0; // errno of one that was not started
	bool bTimedOut = false;
	int Signal = 0;     // that ended it, 0: none
	int ExitCode = 0;   // where it ended by itself
	std::string Output; // stdout and stderr together, at most a megabyte

	bool Succeeded() const { return bStarted && !bTimedOut && Signal == 0 && ExitCode == 0; }
	/** "ended with exit code 2", "was ended by signal 11", "took longer than 60 s". */
	DRYDOCK_API std::string Describe(int TimeLimitSeconds) const;
};

/** Arguments[0] is the program, searched in PATH. Environment: "NAME=VALUE" in place of what is inherited. The child
 * and all it starts are killed when the time is over, and when this process ends, be it by SIGKILL. */
DRYDOCK_API FChildResult RunChild(
	const std::vector<std::string>& Arguments, int TimeLimitSeconds, const std::vector<std::string>& Environment = {});

/** Full path of an executable: Name itself when it has a slash, else searched in PATH; empty when there is none. */
DRYDOCK_API std::string FindProgram(const std::string& Name);

} // namespace Drydock
