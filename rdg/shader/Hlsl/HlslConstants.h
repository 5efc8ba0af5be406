// Arithmetic of constants: by the interpreter's own, so that what is folded has the bits of what runs.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

/** The constant that a value is, if all it depends on is: Constant, Variable with a constant, Member, Index, Swizzle,
 * Elements, Unary, Binary, And, Or, Choose, Select, Convert, Compose, Zero, Cast, Comma, pure Intrinsic. Nothing where
 * it is not constant, or where the operation has no defined result (integer division by 0: Error has the reason). */
DRYDOCK_API std::optional<FConstant> Fold(FTypes& Types, const FValue& Value, std::string* Error = nullptr);

/** Another scalar's bits of the same number, as Convert does at run time. */
DRYDOCK_API uint64_t ConvertConstant(const FTypes& Types, EScalar From, EScalar To, uint64_t Bits);

/** The number of a literal: "1.5f", "0x10u", "07", "1e3L", "10ll"; its type by its suffix. Nothing where it is
 * malformed or too large, with Error. bRealHalf: what FTypes has; "1.5h" is a Half then, else a MinFloat (what `half`
 * is without it). */
struct FNumber
{
	EScalar Scalar = EScalar::LiteralInt;
	uint64_t Bits = 0;
};
DRYDOCK_API std::optional<FNumber> ReadNumber(std::string_view Text, std::string& Error, bool bRealHalf = false);

} // namespace Drydock::Hlsl
