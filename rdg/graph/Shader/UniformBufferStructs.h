// Lists the uniform buffers that an IMPLEMENT_ macro registered in the code loaded so far, and holds the frame's own.
#pragma once

#include "DrydockAPI.h"
#include "Templates/UnrealTemplate.h"

#include <vector>

class FShaderParametersMetadata;

namespace Drydock
{

/** Each HLSL name once, in the order of the names. */
DRYDOCK_API std::vector<const FShaderParametersMetadata*> GetUniformBufferStructs();

/** During its scope a shader that reads this uniform buffer, and whose parameter struct lacks it, gets Contents and a
 * warning (DD6106). They must outlive it. Struct null: nothing is given. */
class DRYDOCK_API FFrameUniformBufferScope : private FNoncopyable
{
public:
	FFrameUniformBufferScope(const FShaderParametersMetadata* Struct, const void* Contents);
	~FFrameUniformBufferScope();
};

/** Struct and contents of the scope that is open; null: none. */
const FShaderParametersMetadata* GetFrameUniformBufferStruct();
DRYDOCK_API const void* GetFrameUniformBufferContents();

} // namespace Drydock
