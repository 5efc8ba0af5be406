// Names matched by patterns with * and ?, as the command line and a config's "dump" take them.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** Whether Text as a whole fits a pattern with * (any text) and ? (any character). */
DRYDOCK_API bool MatchesPattern(const std::string& Pattern, const std::string& Text);

} // namespace Drydock
