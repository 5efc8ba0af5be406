// Checks that operations of floats have floats, those of integers integers: where a front end confuses the two, the
// result would be another number and nobody would know.
#include "SpirvChecker.h"

namespace Drydock
{

using namespace Spirv;

namespace
{

enum class EOperands : uint8_t
{
	Any,
	Floats,
	Integers,
	Signed // integers, not of type uint
};

EOperands GetOperandKind(uint16_t Op)
{
	switch (Op)
	{
	case OpFNegate:
	case OpFAdd:
	case OpFSub:
	case OpFMul:
	case OpFDiv:
	case OpFRem:
	case OpFMod:
	case OpVectorTimesMatrix:
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	case OpOuterProduct:
	case OpDot:
	case OpIsNan:
	case OpIsInf:
	case OpConvertFToU:
	case OpConvertFToS:
		return EOperands::Floats;
	case OpSNegate:
	case OpIAdd:
	case OpISub:
	case OpIMul:
	case OpUDiv:
	case OpSDiv:
	case OpUMod:
	case OpSRem:
	case OpSMod:
	case OpNot:
	case OpBitCount:
	case OpBitReverse:
	case OpConvertSToF:
	case OpConvertUToF:
		return EOperands::Integers;
	default:
		return Op >= OpFOrdEqual && Op <= OpFUnordGreaterThanEqual ? EOperands::Floats
			   : (Op >= OpIEqual && Op <= OpSLessThanEqual) || (Op >= OpShiftRightLogical && Op <= OpBitwiseAnd)
				   ? EOperands::Integers
				   : EOperands::Any;
	}
}

EOperands GetExtOperandKind(uint32_t Ext)
{
	switch (Ext)
	{
	case ExtSAbs:
	case ExtSSign:
		return EOperands::Signed;
	case ExtUMin:
	case ExtSMin:
	case ExtUMax:
	case ExtSMax:
	case ExtUClamp:
	case ExtSClamp:
	case ExtFindILsb:
	case ExtFindSMsb:
	case ExtFindUMsb:
	case ExtUnpackHalf2x16:
	case ExtPackDouble2x32:
		return EOperands::Integers;
	case ExtModf:
	case ExtLdexp:
		return EOperands::Any; // of two kinds
	default:
		return EOperands::Floats;
	}
}

} // namespace

void FSpirvChecker::CheckKinds(const FSpirvInstruction& I) const
{
	const bool bExtended = I.Op == OpExtInst;
	const EOperands Wanted = bExtended ? GetExtOperandKind(I.Operands[1]) : GetOperandKind(I.Op);
	for (size_t i = bExtended ? 2 : 0; i < I.Operands.size() && Wanted != EOperands::Any; ++i)
	{
		const ESpirvType Kind = Module.GetScalarKind(Module.GetValueTypeId(I.Operands[i]), 0);
		const bool bFits = Wanted == EOperands::Floats     ? IsSpirvReal(Kind)
						   : Wanted == EOperands::Integers ? IsSpirvInteger(Kind)
														   : IsSpirvSigned(Kind);
		if (!bFits)
		{
			Module.Fail("the front end made an operation of " +
							std::string(Wanted == EOperands::Floats     ? "floats of what are integers"
										: Wanted == EOperands::Integers ? "integers of what are floats"
																		: "int of what is uint") +
							", whose result would be wrong; write it in another way, by elements for instance",
				&I);
		}
	}
}

void FSpirvChecker::CheckTexelKind(const FSpirvInstruction& I, const FSpirvType& Image) const
{
	const bool bTexel = Module.GetScalarKind(Module.GetValueTypeId(I.Operands[2]), 0) == ESpirvType::Float;
	const bool bImage = Module.GetScalarKind(Image.Element, 0) == ESpirvType::Float;
	if (bTexel != bImage)
	{
		Module.Fail("the front end stores " + std::string(bTexel ? "floats" : "integers") + " into a texture of " +
						(bTexel ? "integers" : "floats") + "; write it in another way, by elements for instance",
			&I);
	}
}

} // namespace Drydock
