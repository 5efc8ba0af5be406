// Computes single scalars of constants by the interpreter's arithmetic, and converts them.
#include "HlslConstantMath.h"

#include "HlslConstants.h"
#include "SpirvOps.h"
#include "SpirvScalarMath.h"
#include "TileExecutor.h"

#include <iterator>

namespace Drydock::Hlsl
{

namespace
{

bool IsConstantLong(ESpirvType Kind)
{
	return Kind == ESpirvType::Long || Kind == ESpirvType::Ulong;
}

struct FConstantOperation
{
	std::string_view Operator;
	uint16_t Real;
	uint16_t Signed;
	uint16_t Unsigned;
	uint16_t Bool;
};

constexpr FConstantOperation ConstantOperations[] = {{"+", Spirv::OpFAdd, Spirv::OpIAdd, Spirv::OpIAdd, Spirv::OpNop},
	{"-", Spirv::OpFSub, Spirv::OpISub, Spirv::OpISub, Spirv::OpNop},
	{"*", Spirv::OpFMul, Spirv::OpIMul, Spirv::OpIMul, Spirv::OpNop},
	{"/", Spirv::OpFDiv, Spirv::OpSDiv, Spirv::OpUDiv, Spirv::OpNop},
	{"%", Spirv::OpFRem, Spirv::OpSRem, Spirv::OpUMod, Spirv::OpNop},
	{"<<", Spirv::OpNop, Spirv::OpShiftLeftLogical, Spirv::OpShiftLeftLogical, Spirv::OpNop},
	{">>", Spirv::OpNop, Spirv::OpShiftRightArithmetic, Spirv::OpShiftRightLogical, Spirv::OpNop},
	{"&", Spirv::OpNop, Spirv::OpBitwiseAnd, Spirv::OpBitwiseAnd, Spirv::OpLogicalAnd},
	{"|", Spirv::OpNop, Spirv::OpBitwiseOr, Spirv::OpBitwiseOr, Spirv::OpLogicalOr},
	{"^", Spirv::OpNop, Spirv::OpBitwiseXor, Spirv::OpBitwiseXor, Spirv::OpLogicalNotEqual},
	{"==", Spirv::OpFOrdEqual, Spirv::OpIEqual, Spirv::OpIEqual, Spirv::OpLogicalEqual},
	{"!=", Spirv::OpFUnordNotEqual, Spirv::OpINotEqual, Spirv::OpINotEqual, Spirv::OpLogicalNotEqual},
	{"<", Spirv::OpFOrdLessThan, Spirv::OpSLessThan, Spirv::OpULessThan, Spirv::OpULessThan},
	{">", Spirv::OpFOrdGreaterThan, Spirv::OpSGreaterThan, Spirv::OpUGreaterThan, Spirv::OpUGreaterThan},
	{"<=", Spirv::OpFOrdLessThanEqual, Spirv::OpSLessThanEqual, Spirv::OpULessThanEqual, Spirv::OpULessThanEqual},
	{">=", Spirv::OpFOrdGreaterThanEqual, Spirv::OpSGreaterThanEqual, Spirv::OpUGreaterThanEqual,
		Spirv::OpUGreaterThanEqual},
	{"~", Spirv::OpNop, Spirv::OpNot, Spirv::OpNot, Spirv::OpNop},
	{"!", Spirv::OpNop, Spirv::OpNop, Spirv::OpNop, Spirv::OpLogicalNot}};

/** An integer, a real or a bool as another integer or real. */
uint64_t ConvertConstantNumber(EScalar From, EScalar To, uint64_t Bits)
{
	const ESpirvType FromKind = GetConstantKind(From);
	const ESpirvType ToKind = GetConstantKind(To);
	const bool bSigned = !IsUnsigned(From);
	const uint16_t Op = IsReal(From) ? (IsReal(To)          ? Spirv::OpFConvert
										   : IsUnsigned(To) ? Spirv::OpConvertFToU
															: Spirv::OpConvertFToS)
						: IsReal(To) ? (bSigned ? Spirv::OpConvertSToF : Spirv::OpConvertUToF)
						: bSigned    ? Spirv::OpSConvert
									 : Spirv::OpUConvert;
	const uint64_t Word = FromSpirvMemory<float>(FromKind, Bits);
	return ToSpirvMemory<float>(ToKind, ConvertSpirv<float>(Op, FromKind, ToKind, Word));
}

/** Runs an operation on the words that the interpreter has for the bits. */
template<typename F>
bool EvaluateWords(EScalar From, EScalar To, const uint64_t* Bits, uint64_t& Result, F Operation)
{
	const ESpirvType FromKind = GetConstantKind(From);
	const ESpirvType ToKind = GetConstantKind(To);
	// Kernels flush denormals of float; D3D keeps those of double.
	const FScopedDenormals Denormals(FromKind == ESpirvType::Double ? EDenormals::Keep : EDenormals::Flush);
	uint64_t Words[3] = {};
	for (int i = 0; i < 3; ++i)
	{
		Words[i] = FromSpirvMemory<float>(FromKind, Bits[i]);
	}
	uint64_t Word = 0;
	const bool bKnown = Operation(FromKind, Words, Word);
	Result = ToSpirvMemory<float>(ToKind, NarrowSpirv<float>(ToKind, Word));
	return bKnown;
}

} // namespace

ESpirvType GetConstantKind(EScalar Scalar)
{
	using enum ESpirvType;
	constexpr ESpirvType Kinds[] = {
		Bool, Int, Uint, Short, Ushort, Int, Uint, Long, Ulong, Long, Float, Half, Float, Double, Double};
	static_assert(std::size(Kinds) == size_t(EScalar::LiteralFloat) + 1);
	return Kinds[size_t(Scalar)];
}

bool EvaluateConstant(uint16_t Op, EScalar Scalar, EScalar To, const uint64_t* Bits, uint64_t& Result)
{
	const uint32_t Width = 8 * GetSpirvBytes(GetConstantKind(Scalar));
	const bool bShift = Op >= Spirv::OpShiftRightLogical && Op <= Spirv::OpShiftLeftLogical;
	const uint64_t Masked[3] = {Bits[0], Bits[1] & (bShift ? Width - 1 : ~uint64_t(0)), Bits[2]};
	return EvaluateWords(Scalar, To, Masked, Result,
		[Op, Width](ESpirvType Kind, const uint64_t* Words, uint64_t& Word)
		{
			const bool bKnown = IsConstantLong(Kind)         ? EvaluateLong(Op, Words, Word)
								: Kind == ESpirvType::Double ? EvaluateOperation<double>(Op, Words, Word)
															 : EvaluateOperation<float>(Op, Words, Word);
			Word >>= Op == Spirv::OpBitReverse && Width == 16 ? 16 : 0;
			return bKnown;
		});
}

bool EvaluateConstantExtended(uint32_t Ext, EScalar Scalar, const uint64_t* Bits, uint64_t& Result)
{
	return EvaluateWords(Scalar, Scalar, Bits, Result,
		[Ext](ESpirvType Kind, const uint64_t* Words, uint64_t& Word)
		{
			return IsConstantLong(Kind)         ? EvaluateExtendedLong(Ext, Words, Word)
				   : Kind == ESpirvType::Double ? EvaluateExtended<double>(Ext, Words, Word)
												: EvaluateExtended<float>(Ext, Words, Word);
		});
}

uint16_t FindConstantOperation(std::string_view Operator, EScalar Scalar)
{
	for (const FConstantOperation& Entry : ConstantOperations)
	{
		if (Entry.Operator == Operator)
		{
			return IsReal(Scalar)            ? Entry.Real
				   : Scalar == EScalar::Bool ? Entry.Bool
				   : IsUnsigned(Scalar)      ? Entry.Unsigned
											 : Entry.Signed;
		}
	}
	return Spirv::OpNop;
}

uint64_t ConvertConstant(const FTypes&, EScalar From, EScalar To, uint64_t Bits)
{
	return ConvertConstantBits(From, To, Bits);
}

uint64_t ConvertConstantBits(EScalar From, EScalar To, uint64_t Bits)
{
	if (GetConstantKind(From) == GetConstantKind(To))
	{
		return Bits;
	}
	// A literal is rounded by the compiler, so that its denormals stay; at run time they are flushed.
	const bool bKeep =
		IsLiteral(From) || (From == EScalar::Double && !IsReal(To)) || (To == EScalar::Double && !IsReal(From));
	const FScopedDenormals Denormals(bKeep ? EDenormals::Keep : EDenormals::Flush);
	if (To == EScalar::Bool)
	{
		const uint64_t Pair[3] = {Bits, 0, 0};
		uint64_t Result = 0;
		EvaluateConstant(FindConstantOperation("!=", From), From, EScalar::Bool, Pair, Result);
		return Result;
	}
	if (From == EScalar::Bool)
	{
		return ConvertConstantNumber(EScalar::Uint, To, Bits != 0);
	}
	const bool bShort = To == EScalar::Short || To == EScalar::Ushort;
	if (bShort && IsReal(From))
	{
		// By way of int, of which the low bits stay.
		return ConvertConstantNumber(EScalar::Int, To, ConvertConstantNumber(From, EScalar::Int, Bits));
	}
	return ConvertConstantNumber(From, To, Bits);
}

} // namespace Drydock::Hlsl
