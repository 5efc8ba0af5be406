// Finds local variables that are read where nothing may have set them.
#pragma once

#include "HlslProgram.h"

#include <utility>
#include <vector>

namespace Drydock::Hlsl
{

/** Each variable once, with the first place. A part that is set counts as all; a loop counts as run at least
 * once. */
std::vector<std::pair<const FVariable*, FPlace>> FindUnset(const FFunction& Function);

} // namespace Drydock::Hlsl
