// Emits arithmetic: most operations are one C++ expression per scalar.
#include "SpirvEmitter.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

/** $0, $1, $2 are the operands, taken as values of Kind (None: of the result's or the first operand's). Functions want
 *  operands of one type; operators mix uniform and varying ones. */
struct FEmitPattern
{
	uint32_t Op;
	const char* Text;
	ESpirvType Kind;
};

namespace
{

constexpr ESpirvType Any = ESpirvType::None;

// clang-format off
constexpr FEmitPattern Operations[] = {
	{OpSNegate, "-$0", Any}, {OpFNegate, "-$0", Float},
	{OpIAdd, "$0 + $1", Any}, {OpFAdd, "$0 + $1", Float}, {OpISub, "$0 - $1", Any}, {OpFSub, "$0 - $1", Float},
	{OpIMul, "$0 * $1", Any}, {OpFMul, "$0 * $1", Float}, {OpFDiv, "$0 / $1", Float},
	{OpUDiv, "IntDivide($0, $1)", Uint}, {OpSDiv, "IntDivide($0, $1)", Int},
	// HLSL's % and fmod have the sign of the dividend; glslang writes them with the operations of GLSL's mod.
	{OpUMod, "IntRemainder($0, $1)", Uint}, {OpSRem, "IntRemainder($0, $1)", Int}, {OpSMod, "IntRemainder($0, $1)", Int},
	{OpFRem, "FRem($0, $1)", Float}, {OpFMod, "FRem($0, $1)", Float},
	{OpIsNan, "IsNan($0)", Float}, {OpIsInf, "IsInf($0)", Float},
	{OpLogicalEqual, "$0 == $1", Bool}, {OpLogicalNotEqual, "$0 != $1", Bool}, {OpLogicalOr, "$0 || $1", Bool},
	{OpLogicalAnd, "$0 && $1", Bool}, {OpLogicalNot, "!$0", Bool},
	{OpIEqual, "$0 == $1", Uint}, {OpINotEqual, "$0 != $1", Uint},
	{OpUGreaterThan, "$0 > $1", Uint}, {OpSGreaterThan, "$0 > $1", Int},
	{OpUGreaterThanEqual, "$0 >= $1", Uint}, {OpSGreaterThanEqual, "$0 >= $1", Int},
	{OpULessThan, "$0 < $1", Uint}, {OpSLessThan, "$0 < $1", Int},
	{OpULessThanEqual, "$0 <= $1", Uint}, {OpSLessThanEqual, "$0 <= $1", Int},
	{OpFOrdEqual, "$0 == $1", Float}, {OpFUnordEqual, "!($0 < $1 || $0 > $1)", Float},
	// D3D's "ne" is true for NaN, which is what HLSL's != means whatever the front end calls it.
	{OpFOrdNotEqual, "$0 != $1", Float}, {OpFUnordNotEqual, "$0 != $1", Float},
	{OpFOrdLessThan, "$0 < $1", Float}, {OpFUnordLessThan, "!($0 >= $1)", Float},
	{OpFOrdGreaterThan, "$0 > $1", Float}, {OpFUnordGreaterThan, "!($0 <= $1)", Float},
	{OpFOrdLessThanEqual, "$0 <= $1", Float}, {OpFUnordLessThanEqual, "!($0 > $1)", Float},
	{OpFOrdGreaterThanEqual, "$0 >= $1", Float}, {OpFUnordGreaterThanEqual, "!($0 < $1)", Float},
	{OpShiftRightLogical, "ShiftRight($0, $1)", Uint}, {OpShiftRightArithmetic, "ShiftRight($0, $1)", Int},
	{OpShiftLeftLogical, "ShiftLeft($0, $1)", Any}, {OpBitwiseOr, "$0 | $1", Any}, {OpBitwiseXor, "$0 ^ $1", Any},
	{OpBitwiseAnd, "$0 & $1", Any}, {OpNot, "~$0", Any}, {OpBitFieldInsert, "BitFieldInsert($0, $1, $2, $3)", Any},
	{OpBitFieldSExtract, "BitFieldExtract($0, $1, $2)", Int}, {OpBitFieldUExtract, "BitFieldExtract($0, $1, $2)", Uint},
	{OpBitReverse, "BitReverse($0)", Uint}, {OpBitCount, "BitCount($0)", Uint},
};

constexpr FEmitPattern Extended[] = {
	{ExtRound, "RoundEven($0)", Float}, {ExtRoundEven, "RoundEven($0)", Float}, {ExtTrunc, "Trunc($0)", Float},
	{ExtFAbs, "Abs($0)", Float}, {ExtSAbs, "Abs($0)", Int}, {ExtFSign, "Sign($0)", Float}, {ExtSSign, "Sign($0)", Int},
	{ExtFloor, "Floor($0)", Float}, {ExtCeil, "Ceil($0)", Float}, {ExtFract, "Frac($0)", Float},
	{ExtRadians, "Radians($0)", Float}, {ExtDegrees, "Degrees($0)", Float}, {ExtSin, "Sin($0)", Float}, {ExtCos, "Cos($0)", Float},
	{ExtTan, "Tan($0)", Float}, {ExtAsin, "Asin($0)", Float}, {ExtAcos, "Acos($0)", Float}, {ExtAtan, "Atan($0)", Float},
	{ExtSinh, "Sinh($0)", Float}, {ExtCosh, "Cosh($0)", Float}, {ExtTanh, "Tanh($0)", Float},
	{ExtAsinh, "Asinh($0)", Float}, {ExtAcosh, "Acosh($0)", Float}, {ExtAtanh, "Atanh($0)", Float}, {ExtAtan2, "Atan2($0, $1)", Float},
	{ExtPow, "Pow($0, $1)", Float}, {ExtExp, "Exp($0)", Float}, {ExtLog, "Log($0)", Float}, {ExtExp2, "Exp2($0)", Float},
	{ExtLog2, "Log2($0)", Float}, {ExtSqrt, "Sqrt($0)", Float}, {ExtInverseSqrt, "InverseSqrt($0)", Float},
	{ExtFMin, "Min($0, $1)", Float}, {ExtNMin, "Min($0, $1)", Float}, {ExtUMin, "Min($0, $1)", Uint}, {ExtSMin, "Min($0, $1)", Int},
	{ExtFMax, "Max($0, $1)", Float}, {ExtNMax, "Max($0, $1)", Float}, {ExtUMax, "Max($0, $1)", Uint}, {ExtSMax, "Max($0, $1)", Int},
	{ExtFClamp, "Clamp($0, $1, $2)", Float}, {ExtNClamp, "Clamp($0, $1, $2)", Float}, {ExtUClamp, "Clamp($0, $1, $2)", Uint},
	{ExtSClamp, "Clamp($0, $1, $2)", Int}, {ExtFMix, "Mix($0, $1, $2)", Float}, {ExtStep, "Step($0, $1)", Float},
	{ExtSmoothStep, "SmoothStep($0, $1, $2)", Float}, {ExtFma, "$0 * $1 + $2", Float},
	{ExtFindILsb, "AsUint(FindLsb($0))", Uint}, {ExtFindSMsb, "FindMsb($0)", Int}, {ExtFindUMsb, "AsUint(FindMsb($0))", Uint},
};
// clang-format on

/** The type that an operation of Kind takes its operands as. */
ESpirvType GetPatternKind(ESpirvType Kind, ESpirvType Operands, ESpirvType Result)
{
	return Kind == Any     ? Result
		   : Kind == Float ? (IsSpirvReal(Operands) ? Operands : Float)
		   : Kind == Int   ? GetSpirvSigned(Operands)
		   : Kind == Uint  ? GetSpirvUnsigned(Operands)
						   : Kind;
}

/** The pattern's text, or another one for 16 bits, which are held in 32. The optimiser makes Fma of a product and a sum
 * that the author wrote, so both are rounded. */
const char* GetText(const FEmitPattern& Pattern, uint16_t Op, ESpirvType Kind)
{
	if (Kind == ESpirvType::Half && Op == OpExtInst && Pattern.Op == ExtFma)
	{
		return "RoundHalf($0 * $1) + $2";
	}
	if (GetSpirvBytes(Kind) != 2 || Op == OpExtInst)
	{
		return Pattern.Text;
	}
	return Op == OpShiftRightLogical || Op == OpShiftRightArithmetic ? "ShiftRight($0, $1 & 15)"
		   : Op == OpShiftLeftLogical                                ? "ShiftLeft($0, $1 & 15)"
		   : Op == OpBitReverse                                      ? "ShiftRight(BitReverse($0), 16u)"
																	 : Pattern.Text;
}

template<size_t Count>
const FEmitPattern* FindPattern(const FEmitPattern (&Patterns)[Count], uint32_t Op)
{
	const auto Found = std::ranges::find(Patterns, Op, &FEmitPattern::Op);
	return Found == std::end(Patterns) ? nullptr : Found;
}

} // namespace

void FSpirvEmitter::EmitInstruction(const FSpirvInstruction& I)
{
	if (I.Op == OpPhi)
	{
		return; // its variables are written by the edges
	}
	Current = &I;
	SourceLine(I);
	if (IsSpirvTerminator(I.Op))
	{
		return;
	}
	if (I.Op == OpFunctionCall) // only functions that discard are left as calls
	{
		Line(Module.bQuads ? "Live = Live & !e;" : "e = M(false);");
		return;
	}
	if (bGroups && I.Op != OpControlBarrier)
	{
		OpenSegment(false);
	}
	bMovable = IsMovable(I);
	OperandLevel = EEmitLevel::Tile;
	if (I.Op == OpExtInst)
	{
		const FEmitPattern* const Pattern = FindPattern(Extended, I.Operands[1]);
		Pattern ? EmitPattern(I, 2, *Pattern) : EmitExtended(I);
	}
	else if (!EmitMemory(I) && !EmitGroups(I) && !EmitQuads(I) && !EmitWaves(I) && !EmitImage(I) && !EmitComposite(I) &&
			 !EmitComponentwise(I) && !EmitMatrix(I))
	{
		Module.Fail(GetSpirvOpName(I.Op) + " is not supported on the CPU tier", &I);
	}
	bMovable = false;
}

void FSpirvEmitter::EmitPattern(const FSpirvInstruction& I, size_t FirstOperand, const FEmitPattern& Pattern)
{
	const bool bFunction = std::string(Pattern.Text).find("($0") != std::string::npos;
	for (uint32_t Index = 0; Index < SizeOf(I.Result); ++Index)
	{
		const ESpirvType ResultKind = Module.GetScalarKind(I.Type, Index);
		// The place of a bit field is one for all components.
		const auto Operand = [this, &I, Index, FirstOperand](size_t k)
		{
			const uint32_t Id = I.Operands[FirstOperand + k];
			return Scalar(Id, SizeOf(Id) == 1 ? 0 : Index);
		};
		bool bVarying = false;
		for (size_t k = 0; k < I.Operands.size() - FirstOperand; ++k)
		{
			bVarying = bVarying || Operand(k).bVarying;
		}
		const ESpirvType Operands = Operand(0).Kind;
		const ESpirvType Kind = GetPatternKind(Pattern.Kind, Operands, ResultKind);
		std::string Text;
		OperandLevel = EEmitLevel::Tile;
		for (const char* c = GetText(Pattern, I.Op, Kind); *c; ++c)
		{
			if (*c == '$')
			{
				Text += UseAs(Operand(size_t(*++c - '0')), Kind, bFunction && bVarying);
			}
			else
			{
				Text += *c;
			}
		}
		Text = IsPerTurn(I, Index) ? PerTurn(I, Index, Text) : WithDenormals(Kind, Text);
		Define(I.Result, Index, {Text, ResultKind == Bool ? Bool : Kind, bVarying, -1});
	}
}

/** A costly function of what only changes from turn to turn of a loop. */
bool FSpirvEmitter::IsPerTurn(const FSpirvInstruction& I, uint32_t Index) const
{
	return I.Op == OpExtInst && Module.GetScalarKind(I.Type, Index) == Float && I.Operands[1] >= ExtSin &&
		   I.Operands[1] <= ExtInverseSqrt && !bInParts && !bGroups && !Loops.empty() &&
		   GetLevel() == EEmitLevel::Pack && !Uniformity.IsVarying(I.Result, Index) &&
		   Dependence.Get(I.Result, Index) == 0 && Dependence.IsSteady(CurrentBlock);
}

std::string FSpirvEmitter::PerTurn(const FSpirvInstruction& I, uint32_t Index, const std::string& Text)
{
	const std::string Suffix = std::to_string(I.Result) + "_" + std::to_string(Index);
	Handles += "\tTTurns<Real> q" + Suffix + ";\n";
	Declare("uint32_t", "n" + Suffix, 0, " = 0");
	return "q" + Suffix + ".Get(n" + Suffix + "++, [&] { return " + Text + "; })";
}

bool FSpirvEmitter::EmitComponentwise(const FSpirvInstruction& I)
{
	if (const FEmitPattern* Pattern = FindPattern(Operations, I.Op))
	{
		EmitPattern(I, 0, *Pattern);
		return true;
	}
	switch (I.Op)
	{
	case OpSelect:
		for (uint32_t Index = 0; Index < SizeOf(I.Result); ++Index)
		{
			const FEmitScalar Condition = Scalar(I.Operands[0], SizeOf(I.Operands[0]) == 1 ? 0 : Index);
			const FEmitScalar A = Scalar(I.Operands[1], Index);
			const FEmitScalar B = Scalar(I.Operands[2], Index);
			const ESpirvType Kind = Module.GetScalarKind(I.Type, Index);
			const bool bVarying = Condition.bVarying || A.bVarying || B.bVarying;
			OperandLevel = EEmitLevel::Tile;
			Define(I.Result, Index,
				{"Select(" + Use(Condition) + ", " + UseAs(A, Kind, bVarying) + ", " + UseAs(B, Kind, bVarying) + ")",
					Kind, bVarying, -1});
		}
		return true;
	case OpConvertFToU:
	case OpConvertFToS:
	case OpConvertSToF:
	case OpConvertUToF:
	case OpUConvert:
	case OpSConvert:
	case OpFConvert:
		EmitConversion(I);
		return true;
	case OpBitcast:
		EmitBitcast(I);
		return true;
	case OpIAddCarry:
	case OpISubBorrow:
		for (uint32_t Index = 0; Index < SizeOf(I.Operands[0]); ++Index)
		{
			const FEmitScalar A = Scalar(I.Operands[0], Index);
			const FEmitScalar B = Scalar(I.Operands[1], Index);
			const ESpirvType Kind = Module.GetScalarKind(I.Type, Index);
			const bool bVarying = A.bVarying || B.bVarying;
			OperandLevel = EEmitLevel::Tile;
			const std::string X = UseAs(A, Kind, bVarying);
			const std::string Y = UseAs(B, Kind, bVarying);
			const std::string Made = "(" + X + (I.Op == OpIAddCarry ? " + " : " - ") + Y + ")";
			const std::string Over = I.Op == OpIAddCarry ? Made + " < " + X : X + " < " + Y;
			const auto One = [&](int Value)
			{
				return UseAs(Literal(Kind, uint64_t(Value)), Kind, bVarying);
			};
			Define(I.Result, Index, {Made, Kind, bVarying, -1});
			Define(I.Result, SizeOf(I.Operands[0]) + Index,
				{"Select(" + Over + ", " + One(1) + ", " + One(0) + ")", Kind, bVarying, -1});
		}
		return true;
	default:
		return false;
	}
}

void FSpirvEmitter::EmitConversion(const FSpirvInstruction& I)
{
	const bool bSigned = I.Op == OpConvertSToF || I.Op == OpSConvert;
	for (uint32_t Index = 0; Index < SizeOf(I.Result); ++Index)
	{
		const FEmitScalar Source = Scalar(I.Operands[0], Index);
		const ESpirvType Kind = Module.GetScalarKind(I.Type, Index);
		const ESpirvType Integer = bSigned ? GetSpirvSigned(Source.Kind) : GetSpirvUnsigned(Source.Kind);
		const bool bSmall = GetSpirvBytes(Source.Kind) <= 4;
		std::string Text;
		ESpirvType Made = Kind;
		OperandLevel = EEmitLevel::Tile;
		switch (I.Op)
		{
		case OpConvertFToU:
		case OpConvertFToS:
			Made = I.Op == OpConvertFToU ? GetSpirvUnsigned(Kind) : GetSpirvSigned(Kind);
			Text = (Made == Uint && bSmall     ? "ToUint("
					   : Made == Int && bSmall ? "ToInt("
											   : std::string("ConvertTo<") + MemoryName(Made) + ">(") +
				   Use(Source) + ")";
			break;
		case OpConvertSToF:
		case OpConvertUToF:
			Text = (Kind == ESpirvType::Double ? "ConvertTo<double>("
					   : bSmall                ? "ToReal<Real>("
											   : "ConvertTo<Real>(") +
				   UseAs(Source, Integer, false) + ")";
			break;
		case OpFConvert:
			// A double is rounded to 16 bits at once, not to a float first.
			Text = Kind == Source.Kind || (bSmall && Kind != ESpirvType::Double) ? Use(Source)
				   : Kind == ESpirvType::Half   ? "ConvertTo<Real>(RoundHalf(" + Use(Source) + "))"
				   : Kind == ESpirvType::Double ? "ConvertTo<double>(" + Use(Source) + ")"
												: "ConvertTo<Real>(" + Use(Source) + ")";
			break;
		default:
			Text = UseAs(Source, Integer, false);
			Made = Integer;
			break;
		}
		Define(I.Result, Index, {Text, Made, Source.bVarying, -1});
	}
}

/** Components that are longer or shorter than the operand's are put together or cut, the first one lowest. */
void FSpirvEmitter::EmitBitcast(const FSpirvInstruction& I)
{
	const uint32_t From = GetSpirvBytes(Scalar(I.Operands[0], 0).Kind);
	const uint32_t To = GetSpirvBytes(Module.GetScalarKind(I.Type, 0));
	const auto Bits = [this](const FEmitScalar& S) -> std::string
	{
		return S.Kind == ESpirvType::Half     ? "HalfBits(" + Use(S) + ")"
			   : S.Kind == ESpirvType::Double ? "DoubleBits(" + Use(S) + ")"
											  : UseAs(S, GetSpirvUnsigned(S.Kind), false);
	};
	for (uint32_t Index = 0; Index < SizeOf(I.Result); ++Index)
	{
		const ESpirvType Kind = Module.GetScalarKind(I.Type, Index);
		const uint32_t First = From > To ? Index / (From / To) : Index * (To / From);
		const FEmitScalar Source = Scalar(I.Operands[0], First);
		bool bVarying = Source.bVarying;
		OperandLevel = EEmitLevel::Tile;
		if (Kind == Source.Kind)
		{
			Define(I.Result, Index, {Use(Source), Kind, bVarying, -1});
			continue;
		}
		if (From == 4 && To == 4)
		{
			const char* const Cast = Kind == Float ? "AsReal<Real>(" : Kind == Int ? "AsInt(" : "AsUint(";
			Define(I.Result, Index, {Cast + Use(Source) + ")", Kind, bVarying, -1});
			continue;
		}
		ESpirvType Whole = GetSpirvUnsigned(Kind);
		std::string Text = Bits(Source);
		if (From > To)
		{
			const uint32_t Shift = Index % (From / To) * To * 8;
			const ESpirvType Long = GetSpirvUnsigned(Source.Kind);
			Text = Shift ? "ShiftRight(" + Text + ", " + Literal(Long, Shift).Text + ")" : Text;
			Text = UseAs({Text, Long, bVarying, -1}, Whole, false);
		}
		for (uint32_t k = 1; k < To / From; ++k)
		{
			const FEmitScalar Next = Scalar(I.Operands[0], First + k);
			bVarying = bVarying || Next.bVarying;
			const std::string Longer =
				UseAs({Bits(Next), GetSpirvUnsigned(Next.Kind), Next.bVarying, -1}, Whole, false);
			Text = (k == 1 ? UseAs({Text, GetSpirvUnsigned(Source.Kind), false, -1}, Whole, false) : Text) +
				   " | ShiftLeft(" + Longer + ", " + Literal(Whole, k * From * 8).Text + ")";
		}
		if (IsSpirvReal(Kind))
		{
			Text = (Kind == Float                 ? "AsReal<Real>("
					   : Kind == ESpirvType::Half ? "HalfOfBits<Real>("
												  : "DoubleOfBits(") +
				   Text + ")";
			Whole = Kind;
		}
		Define(I.Result, Index, {Text, Whole, bVarying, -1});
	}
}

} // namespace Drydock
