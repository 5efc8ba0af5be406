// The manual page, made from what the parser holds.
#pragma once

#include "Program/ProgramModel.h"

namespace Drydock
{

/** drydock(1) in the man macros of groff and mandoc: verbs by their groups, each with its arguments and options; exit
 * codes, environment, files. */
DRYDOCK_API std::string MakeManPage(const FProgramModel& Model);

} // namespace Drydock
