// Writes the JSON schema of configs: from config keys, the settings table, show flags, console variables and the names
// that higher rooms know. It is JSON Schema draft 7. The published schema (configs/schema) is that of
// Extensions/PublishedSchema.h.
#pragma once

#include "Config/ConfigSchemaNames.h"
#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

DRYDOCK_API std::string MakeConfigSchema(const FSchemaNames& Names = {});

} // namespace Drydock
