// One scalar of one operation, written plainly from the rules of Direct3D and SPIR-V: the model's arithmetic.
// Elementary functions (exp2, pow, sin...) are the library's own, which have their own tests.
#pragma once

#include "SpirvOps.h"

#include <cstdint>

namespace Drydock
{

/** Result bits of a component-wise operation on 32-bit scalars; false when Op is none of them. Bools are 0 and 1. */
bool EvaluateOperation(uint16_t Op, const uint32_t* Operands, uint32_t& Result);

/** The same for GLSL.std.450. */
bool EvaluateExtended(uint32_t Ext, const uint32_t* Operands, uint32_t& Result);

float ToFloat(uint32_t Bits);
uint32_t ToBits(float Value);

} // namespace Drydock
