// Scripts that complete drydock's command line in bash and zsh, made from what the parser holds.
#pragma once

#include "Program/ProgramModel.h"

namespace Drydock
{

/** The script for share/bash-completion/completions/drydock, or to be sourced. It completes verbs, options and their
 * words, configs (*.json), folders and files, and by asking the program (`drydock list ... --names`) console variables,
 * settings, effects, and of a config that is on the line already, its passes. */
DRYDOCK_API std::string MakeBashCompletion(const FProgramModel& Model);

/** The same for share/zsh/site-functions/_drydock, with the description of each option. */
DRYDOCK_API std::string MakeZshCompletion(const FProgramModel& Model);

} // namespace Drydock
