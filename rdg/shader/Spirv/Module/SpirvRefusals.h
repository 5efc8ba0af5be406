// Describes what drydock does not run, in HLSL's words: the function or type as the author wrote it, and what to do
// instead.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** "ddx: there are no derivatives on the CPU tier: ...", or nothing when the operation is not one that is refused.
 *  Operands: what follows type and result, as many as are there. */
std::string ExplainRefusedOp(uint16_t Op, const uint32_t* Operands, size_t NumOperands);

/** The same for an input that only such a function reads (WaveGetLaneIndex). */
std::string ExplainRefusedBuiltIn(uint32_t BuiltIn);

/** "uint", "float16_t". Kind: a scalar. */
DRYDOCK_API const char* GetHlslScalarName(ESpirvType Kind);

/** "float4", "float3x3", "float4[16]", "FMyStruct", "Texture2D<float4>". */
std::string GetHlslTypeName(const FSpirvModule& Module, const FSpirvType& Type);

} // namespace Drydock
