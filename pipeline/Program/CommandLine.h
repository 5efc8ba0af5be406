// The program's command line: finds the verb, reads its options and calls it.
#pragma once

#include "DrydockAPI.h"
#include "Program/ProgramModel.h"

#include <string>
#include <vector>

namespace Drydock
{

class FArgumentParser;

/** The parser with all verbs. */
FArgumentParser MakeProgram();

/** The model of the program's command line. */
DRYDOCK_API FProgramModel MakeProgramModel();

/** Arguments: those behind the program's name. Returns the exit code; what is wrong with the arguments themselves is
 * printed to stderr, with the nearest verb or option, and all verbs where there are no arguments. Throws what a verb
 * throws, and FError (exit code 3) where its result cannot be printed. With --json, what a verb throws and what is
 * wrong with its arguments goes to stdout as well, as WriteMessages has it. */
DRYDOCK_API int CallProgram(const std::vector<std::string>& Arguments);

} // namespace Drydock
