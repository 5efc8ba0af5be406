// The names of settings as the engine's editor shows them.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

struct FSettingField;

/** "Intensity" of BloomIntensity, as the editor has it below Lens|Bloom. A setting without a name of its own there has
 * the words of its member: "Vignette Intensity". */
DRYDOCK_API std::string GetDisplayName(const FSettingField& Field);

} // namespace Drydock
