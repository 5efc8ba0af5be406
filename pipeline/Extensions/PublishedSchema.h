// Writes the schema of configs with all names that this program knows. It is the text of configs/schema, of `drydock
// schema`, and of the schema beside a scaffolded config.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** The schema with the types and parameters of the passes and extensions that are registered, those of loaded plugins
 * too; hooks, metrics and engine versions. A test holds the published file to it. */
DRYDOCK_API std::string MakePublishedSchema();

} // namespace Drydock
