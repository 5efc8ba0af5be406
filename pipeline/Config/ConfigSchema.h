// The published JSON schema, made from the list of config keys, the settings table and the list of show flags. The
// file in configs/schema is this text; a test holds them together. It is JSON Schema draft 7.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

DRYDOCK_API std::string MakeConfigSchema();

} // namespace Drydock
