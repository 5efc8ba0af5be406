// The program's command line: finds the verb, reads its options and calls it.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Arguments: those behind the program's name. Returns the exit code; what is wrong with the arguments themselves is
 * printed to stderr, with the nearest verb or option. Throws what a verb throws, and FError (exit
 * code 3) where its result cannot be printed. */
DRYDOCK_API int CallProgram(const std::vector<std::string>& Arguments);

} // namespace Drydock
