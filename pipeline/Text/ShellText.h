// Text for a shell to read.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** A word as a shell takes it, in quotes where it needs them. */
DRYDOCK_API std::string QuoteForShell(const std::string& Word);

} // namespace Drydock
