// The schema of configs with all names that this program knows: what configs/schema holds, `drydock schema` prints, and
// a scaffolded config has beside it.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** With the types and parameters of the passes and extensions that are registered, those of loaded plugins too; hooks,
 * metrics and engine versions. A test holds the published file to it. */
DRYDOCK_API std::string MakePublishedSchema();

} // namespace Drydock
