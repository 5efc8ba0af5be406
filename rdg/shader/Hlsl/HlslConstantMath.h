// Single scalars of constants, in the bits that FConstant has, by the interpreter's arithmetic.
#pragma once

#include "HlslTypes.h"
#include "SpirvModule.h"

namespace Drydock::Hlsl
{

/** How a scalar is computed: what is literal as long and double, min types as their 32 bits. */
ESpirvType GetConstantKind(EScalar Scalar);

/** Op of SPIR-V on scalars of one type; a shift takes the low bits of its count. Result has the scalar To. */
bool EvaluateConstant(uint16_t Op, EScalar Scalar, EScalar To, const uint64_t* Bits, uint64_t& Result);

/** The same for GLSL.std.450; the result has the type of the operands. */
bool EvaluateConstantExtended(uint32_t Ext, EScalar Scalar, const uint64_t* Bits, uint64_t& Result);

/** ConvertConstant. */
uint64_t ConvertConstantBits(EScalar From, EScalar To, uint64_t Bits);

/** The operation of HLSL's `+`, `<<`, `==` on scalars of this type; 0 (OpNop): there is none. */
uint16_t FindConstantOperation(std::string_view Operator, EScalar Scalar);

} // namespace Drydock::Hlsl
