// Checks that operations of floats have floats, those of integers integers: where a front end confuses the two, the
// result would be another number and nobody would know.
#include "SpirvChecker.h"

#include "SpirvFlow.h"

#include <set>

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
	static const std::set<uint16_t> Floats = {OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod,
		OpVectorTimesMatrix, OpMatrixTimesVector, OpMatrixTimesMatrix, OpOuterProduct, OpDot, OpIsNan, OpIsInf,
		OpConvertFToU, OpConvertFToS};
	static const std::set<uint16_t> Integers = {OpSNegate, OpIAdd, OpISub, OpIMul, OpUDiv, OpSDiv, OpUMod, OpSRem,
		OpSMod, OpIAddCarry, OpISubBorrow, OpNot, OpBitFieldInsert, OpBitFieldSExtract, OpBitFieldUExtract, OpBitCount,
		OpBitReverse, OpConvertSToF, OpConvertUToF};
	const auto IsFrom = [Op](uint16_t First, uint16_t Last)
	{
		return Op >= First && Op <= Last;
	};
	return Floats.count(Op) || IsFrom(OpFOrdEqual, OpFUnordGreaterThanEqual) ? EOperands::Floats
		   : Integers.count(Op) || IsFrom(OpIEqual, OpSLessThanEqual) || IsFrom(OpShiftRightLogical, OpBitwiseAnd)
			   ? EOperands::Integers
			   : EOperands::Any;
}

EOperands GetExtOperandKind(uint32_t Ext)
{
	static const std::set<uint32_t> Integers = {ExtUMin, ExtSMin, ExtUMax, ExtSMax, ExtUClamp, ExtSClamp, ExtFindILsb,
		ExtFindSMsb, ExtFindUMsb, ExtUnpackHalf2x16, ExtPackDouble2x32};
	const FSpirvNorms* const Norms = FindSpirvNorms(Ext);
	return Ext == ExtSAbs || Ext == ExtSSign                  ? EOperands::Signed
		   : Integers.count(Ext) || (Norms && !Norms->bPacks) ? EOperands::Integers
		   : Ext == ExtModf || Ext == ExtLdexp                ? EOperands::Any // of two kinds
															  : EOperands::Floats;
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
