// Lists the uniform buffers that an IMPLEMENT_ macro registered in the code loaded so far.
#pragma once

#include "DrydockAPI.h"

#include <vector>

class FShaderParametersMetadata;

namespace Drydock
{

/** Each HLSL name once, in the order of the names. */
DRYDOCK_API std::vector<const FShaderParametersMetadata*> GetUniformBufferStructs();

} // namespace Drydock
