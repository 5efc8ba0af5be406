// Finds the lane widths that this build has code for and this CPU runs.
#pragma once

#include "DrydockAPI.h"
#include "ShaderCompileRequest.h"

#include <cstdint>
#include <string>

namespace Drydock
{

/** The widest lane count: 16, 8 or 4 for float, half as many for double. */
DRYDOCK_API int32_t GetWidestLanes(bool bDouble);

/** True when kernels of that width can run; float 4, 8, 16 and double 2, 4, 8 exist. */
DRYDOCK_API bool AreLanesSupported(bool bDouble, int32_t Lanes);

/** The float lanes that this build has code for, for messages: "4, 8, 16", or with DRYDOCK_INSTRUCTION_SETS=native one
 * of them. */
DRYDOCK_API std::string GetBuiltLanes();

/** Lanes 0 becomes the widest. Throws FError DD6003 for a lane count that the type or the CPU does not have, and for a
 * size that waves cannot have. */
DRYDOCK_API FLaneConfig ResolveLanes(FLaneConfig Lanes);

} // namespace Drydock
