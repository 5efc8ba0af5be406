// Writes the JSON schema of configs, from the list of config keys, the settings table, the list of show flags, the
// console variables and the names that higher rooms know. It is JSON Schema draft 7. The published schema
// (configs/schema) is that of Extensions/PublishedSchema.h.
#pragma once

#include "Config/ConfigSchemaNames.h"
#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

DRYDOCK_API std::string MakeConfigSchema(const FSchemaNames& Names = {});

} // namespace Drydock
