// Tells which lane widths this CPU runs.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>

namespace Drydock
{

/** The widest lane count of the CPU: 16, 8 or 4 for float, half of it for double. */
DRYDOCK_API int32_t GetWidestLanes(bool bDouble);

/** True when the CPU runs kernels of that width; float 4, 8, 16 and double 2, 4, 8 exist. */
DRYDOCK_API bool AreLanesSupported(bool bDouble, int32_t Lanes);

} // namespace Drydock
