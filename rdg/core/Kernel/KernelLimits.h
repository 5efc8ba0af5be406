// Stops a shader's loop that does not end, after r.Drydock.ShaderLoopLimit turns, with a message that names pass,
// shader, line and pixel. A GPU's driver would take the device away.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"

namespace Drydock
{

/** The limits that hold now, for FKernelArgs. A loop that goes on is FError DD6041, exit code 2. The calling thread's:
 * valid until it ends, and changed by its next call. */
DRYDOCK_API const FKernelLimits* GetKernelLimits();

} // namespace Drydock
