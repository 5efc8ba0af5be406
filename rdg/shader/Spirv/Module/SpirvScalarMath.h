// One scalar of one operation, written plainly from the rules of Direct3D and SPIR-V: the model's arithmetic, in float
// and in double. Elementary functions (exp2, pow, sin...) are the library's own, which have their own tests.
// SpirvWideMath.cpp: what makes one width of another.
#pragma once

#include "SpirvModule.h"

#include <cstdint>

namespace Drydock
{

/** A number of the shader. Float and float16_t: the bits of a Real; double: of a double; integers of 16 bits are
 * extended to 32 by their sign, those of 32 and bools (0 and 1) stand in the low half. */
template<typename Real>
using TSpirvWord = uint64_t;

/** Result bits of a component-wise operation on scalars; false when Op is none of them. */
template<typename Real>
bool EvaluateOperation(uint16_t Op, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result);

/** The same for GLSL.std.450. */
template<typename Real>
bool EvaluateExtended(uint32_t Ext, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result);

/** The same of integers of 64 bits. Results of comparisons are bools. */
bool EvaluateLong(uint16_t Op, const uint64_t* Operands, uint64_t& Result);
bool EvaluateExtendedLong(uint32_t Ext, const uint64_t* Operands, uint64_t& Result);

/** OpConvert*To* and Op*Convert. Only Ops that convert. */
template<typename Real>
uint64_t ConvertSpirv(uint16_t Op, ESpirvType From, ESpirvType To, uint64_t Word);

/** An operation whose numbers are those of its operands, bit for bit: nothing is made narrow. */
constexpr bool MovesSpirvNumbers(uint16_t Op)
{
	return Op == Spirv::OpLoad || Op == Spirv::OpSelect || Op == Spirv::OpBitcast ||
		   (Op >= Spirv::OpVectorExtractDynamic && Op <= Spirv::OpTranspose);
}

/** The result of an operation as its kind holds it: 16 bits are made narrow, all else stays. */
template<typename Real>
uint64_t NarrowSpirv(ESpirvType Kind, uint64_t Word);

/** Between a word and the bits that the kind has in memory. */
template<typename Real>
uint64_t ToSpirvMemory(ESpirvType Kind, uint64_t Word);
template<typename Real>
uint64_t FromSpirvMemory(ESpirvType Kind, uint64_t Bits);

template<typename Real>
Real ToSpirvReal(TSpirvWord<Real> Bits)
{
	if constexpr (sizeof(Real) == 4)
	{
		return __builtin_bit_cast(Real, uint32_t(Bits));
	}
	else
	{
		return __builtin_bit_cast(Real, Bits);
	}
}

template<typename Real>
TSpirvWord<Real> ToSpirvWord(Real Value)
{
	if constexpr (sizeof(Real) == 4)
	{
		return __builtin_bit_cast(uint32_t, Value);
	}
	else
	{
		return __builtin_bit_cast(uint64_t, Value);
	}
}

} // namespace Drydock
