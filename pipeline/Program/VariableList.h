// Makes the text that `drydock list cvars` prints.
#pragma once

#include "Budget/RunOptions.h"

#include <string>

namespace Drydock
{

/** Prints the console variables whose name matches Filter (FilterConsoleVariables); of a single one its whole help.
 * With a config, --set or --exec in Options: as these set them. Returns the exit code; throws FError. */
int PrintVariables(const FRunOptions& Options, const std::string& Filter, bool bJson);

} // namespace Drydock
