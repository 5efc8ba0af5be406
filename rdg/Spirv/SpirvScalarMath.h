// One scalar of one operation, written plainly from the rules of Direct3D and SPIR-V: the model's arithmetic, in float
// and in double. Elementary functions (exp2, pow, sin...) are the library's own, which have their own tests.
#pragma once

#include "SpirvOps.h"

#include <cstdint>
#include <type_traits>

namespace Drydock
{

/** Bits of a number of the shader: as many as its arithmetic has for reals; integers and bools (0 and 1) in the low
 * 32. */
template<typename Real>
using TSpirvWord = std::conditional_t<sizeof(Real) == 4, uint32_t, uint64_t>;

/** Result bits of a component-wise operation on scalars; false when Op is none of them. */
template<typename Real>
bool EvaluateOperation(uint16_t Op, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result);

/** The same for GLSL.std.450. */
template<typename Real>
bool EvaluateExtended(uint32_t Ext, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result);

template<typename Real>
Real ToSpirvReal(TSpirvWord<Real> Bits)
{
	return __builtin_bit_cast(Real, Bits);
}

template<typename Real>
TSpirvWord<Real> ToSpirvWord(Real Value)
{
	return __builtin_bit_cast(TSpirvWord<Real>, Value);
}

} // namespace Drydock
