// Writes operations with HLSL's signs and names.
#include "OperationText.h"

#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

using namespace Spirv;

namespace
{

struct FOperationName
{
	uint32_t Op;
	const char* Text; // one character: between the operands; else a function
};

constexpr FOperationName Operations[] = {{OpFAdd, "+"}, {OpFSub, "-"}, {OpFMul, "*"}, {OpFDiv, "/"}, {OpFRem, "%"},
	{OpFMod, "%"}, {OpVectorTimesScalar, "*"}, {OpMatrixTimesScalar, "*"}, {OpDot, "dot"}, {OpVectorTimesMatrix, "mul"},
	{OpMatrixTimesVector, "mul"}, {OpMatrixTimesMatrix, "mul"}, {OpBitcast, "asfloat"}, {OpFNegate, "-"}};

constexpr FOperationName Functions[] = {{ExtRound, "round"}, {ExtRoundEven, "round"}, {ExtTrunc, "trunc"},
	{ExtFAbs, "abs"}, {ExtFSign, "sign"}, {ExtFloor, "floor"}, {ExtCeil, "ceil"}, {ExtFract, "frac"},
	{ExtRadians, "radians"}, {ExtDegrees, "degrees"}, {ExtSin, "sin"}, {ExtCos, "cos"}, {ExtTan, "tan"},
	{ExtAsin, "asin"}, {ExtAcos, "acos"}, {ExtAtan, "atan"}, {ExtSinh, "sinh"}, {ExtCosh, "cosh"}, {ExtTanh, "tanh"},
	{ExtAtan2, "atan2"}, {ExtPow, "pow"}, {ExtExp, "exp"}, {ExtLog, "log"}, {ExtExp2, "exp2"}, {ExtLog2, "log2"},
	{ExtSqrt, "sqrt"}, {ExtInverseSqrt, "rsqrt"}, {ExtFMin, "min"}, {ExtNMin, "min"}, {ExtFMax, "max"},
	{ExtNMax, "max"}, {ExtFClamp, "clamp"}, {ExtNClamp, "clamp"}, {ExtFMix, "lerp"}, {ExtStep, "step"},
	{ExtSmoothStep, "smoothstep"}, {ExtFma, "mad"}, {ExtLdexp, "ldexp"}, {ExtLength, "length"},
	{ExtDistance, "distance"}, {ExtCross, "cross"}, {ExtNormalize, "normalize"}, {ExtReflect, "reflect"},
	{ExtRefract, "refract"}, {ExtModf, "modf"}};

template<size_t Count>
const char* FindName(const FOperationName (&Names)[Count], uint32_t Op)
{
	const auto Found = std::ranges::find(Names, Op, &FOperationName::Op);
	return Found == std::end(Names) ? nullptr : Found->Text;
}

/** Functions of whole vectors: their operands are written out. */
bool TakesVectors(const FSpirvInstruction& I)
{
	if (I.Op != OpExtInst)
	{
		return I.Op == OpDot || I.Op == OpVectorTimesMatrix || I.Op == OpMatrixTimesVector ||
			   I.Op == OpMatrixTimesMatrix;
	}
	const uint32_t Ext = I.Operands[1];
	return Ext >= ExtLength && Ext <= ExtRefract;
}

} // namespace

std::string FormatReal(double Value)
{
	return std::isnan(Value)               ? "NaN"
		   : std::isinf(Value)             ? (Value < 0 ? "-Inf" : "Inf")
		   : double(float(Value)) == Value ? FormatShortest(float(Value))
										   : FormatShortest(Value);
}

std::string FormatWord(const FSpirvThreadView& Thread, uint32_t Word, ESpirvType Kind)
{
	return IsSpirvReal(Kind)          ? FormatReal(Thread.GetNumber(Word, Kind))
		   : Kind == ESpirvType::Long ? std::to_string(int64_t(Thread.GetWideBits(Word)))
		   : IsSpirvSigned(Kind)      ? std::to_string(int32_t(Thread.GetBits(Word)))
									  : std::to_string(Thread.GetWideBits(Word));
}

std::string DescribeOperation(
	const FSpirvProgram& Program, const FSpirvThreadView& Thread, const FSpirvStep& Step, uint32_t Component)
{
	const FSpirvInstruction& I = *Step.I;
	const size_t First = I.Op == OpExtInst ? 2 : 0;
	const char* const Name = I.Op == OpExtInst ? FindName(Functions, I.Operands[1]) : FindName(Operations, I.Op);
	std::vector<std::string> Operands;
	for (size_t k = First; k < I.Operands.size(); ++k)
	{
		const uint32_t Type = Program.Module.GetValueTypeId(I.Operands[k]);
		const uint32_t Size = Program.Module.GetType(Type).NumScalars;
		if (!Size)
		{
			continue; // a pointer
		}
		const uint32_t Word = Program.Args[Step.FirstArg + k];
		const auto Format = [&](uint32_t Index)
		{
			const ESpirvType Kind = Program.Module.GetScalarKind(Type, Index);
			return FormatWord(Thread, Word + Index, Kind);
		};
		std::string Text;
		if (TakesVectors(I))
		{
			for (uint32_t Index = 0; Index < Size; ++Index)
			{
				Text += (Index ? ", " : "") + Format(Index);
			}
			Text = Size > 1 ? "(" + Text + ")" : Text;
		}
		else
		{
			Text = Format(Size == 1 ? 0 : std::min(Component, Size - 1));
		}
		Operands.push_back(Text);
	}
	if (!Name)
	{
		return "an operation";
	}
	const std::string Sign = Name;
	if (Sign.size() == 1 && Operands.size() == 2)
	{
		return Operands[0] + " " + Sign + " " + Operands[1];
	}
	std::string Text = Sign.size() == 1 ? Sign : Sign + "(";
	for (size_t i = 0; i < Operands.size(); ++i)
	{
		Text += (i ? ", " : "") + Operands[i];
	}
	return Sign.size() == 1 ? Text : Text + ")";
}

} // namespace Drydock
