// Instructions on scalars, vectors and matrices. SpirvThreadFunctions.inl: those of GLSL.std.450.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"

#include <cmath>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

/** The result is made of the words in Sources. */
template<typename Real>
void TSpirvThread<Real>::Move(const FSpirvStep& Step)
{
	for (size_t i = 0; i < Sources.size() && i < Step.Size; ++i)
	{
		const bool bNone = Sources[i] == GNoSpirvWord;
		Words[Step.To + i] = bNone ? 0 : Words[Sources[i]];
		if (!Undefined.empty())
		{
			Undefined[Step.To + i] = bNone ? 0 : Undefined[Sources[i]];
		}
	}
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteComposite(const FSpirvStep& Step)
{
	const FSpirvInstruction& I = *Step.I;
	const auto Append = [this](uint32_t First, uint32_t Size)
	{
		for (uint32_t i = 0; i < Size; ++i)
		{
			Sources.push_back(First + i);
		}
	};
	Sources.clear();
	switch (I.Op)
	{
	case OpVectorShuffle:
	{
		const uint32_t First = SizeOf(Step, 0);
		for (size_t i = 2; i < I.Operands.size(); ++i)
		{
			const uint32_t Index = I.Operands[i];
			Sources.push_back(Index == ~0u    ? GNoSpirvWord
							  : Index < First ? Arg(Step, 0) + Index
											  : Arg(Step, 1) + Index - First);
		}
		break;
	}
	case OpCompositeConstruct:
		for (size_t k = 0; k < I.Operands.size(); ++k)
		{
			Append(Arg(Step, k), SizeOf(Step, k));
		}
		break;
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const size_t Composite = I.Op == OpCompositeInsert ? 1 : 0;
		const auto [Offset, Type] = Program.Module.FindPart(Program.Module.GetValueTypeId(I.Operands[Composite]),
			I.Operands.data() + Composite + 1, I.Operands.data() + I.Operands.size());
		const uint32_t Size = Program.WordsOf(Type);
		if (I.Op == OpCompositeExtract)
		{
			Append(Arg(Step, 0) + Offset, Size);
			break;
		}
		Append(Arg(Step, 1), Step.Size);
		for (uint32_t i = 0; i < Size; ++i)
		{
			Sources.at(Offset + i) = Arg(Step, 0) + i;
		}
		break;
	}
	case OpVectorExtractDynamic:
		Append(Arg(Step, 0) + std::min(Bits(Step, 1), SizeOf(Step, 0) - 1), 1);
		break;
	case OpVectorInsertDynamic:
		Append(Arg(Step, 0), Step.Size);
		if (Bits(Step, 2) < Step.Size)
		{
			Sources[Bits(Step, 2)] = Arg(Step, 1);
		}
		break;
	case OpTranspose:
	{
		const uint32_t Columns = Program.Module.GetType(I.Type).Count;
		const uint32_t Rows = Step.Size / Columns;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Sources.push_back(Arg(Step, 0) + (i % Rows) * Columns + i / Rows);
		}
		break;
	}
	case OpCopyObject:
		Append(Arg(Step, 0), Step.Size);
		break;
	case OpSelect:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const bool bFirst = Bits(Step, 0, SizeOf(Step, 0) == 1 ? 0 : i) != 0;
			Sources.push_back(Arg(Step, bFirst ? 1 : 2) + i);
		}
		break;
	default:
		return false;
	}
	Move(Step);
	return true;
}

template<typename Real>
template<typename Number>
bool TSpirvThread<Real>::ExecuteMatrix(const FSpirvStep& Step)
{
	// Element (Row, Column) of an operand that has Rows rows.
	const auto At = [this, &Step](size_t Operand, uint32_t Rows, uint32_t Row, uint32_t Column)
	{
		return GetValue<Number>(Step, Operand, Column * Rows + Row);
	};
	FWord* const Out = Step.Size ? Result(Step) : nullptr;
	switch (Step.I->Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			// The front end has them of integers too.
			const FWord Product = Value(Step, 0)[i] * Value(Step, 1)[0];
			const bool bLong = GetSpirvBytes(Step.Kind) == 8;
			Out[i] = IsReal(Step.I->Type, i)
						 ? ToSpirvWord<Number>(GetValue<Number>(Step, 0, i) * GetValue<Number>(Step, 1, 0))
					 : bLong ? Product
							 : uint32_t(Product);
		}
		return true;
	case OpDot:
	case OpVectorTimesMatrix:
	{
		const uint32_t Rows = SizeOf(Step, 0);
		for (uint32_t Column = 0; Column < Step.Size; ++Column)
		{
			Number Sum = At(0, Rows, 0, 0) * At(1, Rows, 0, Column);
			for (uint32_t Row = 1; Row < Rows; ++Row)
			{
				Sum += At(0, Rows, Row, 0) * At(1, Rows, Row, Column);
			}
			Out[Column] = ToSpirvWord<Number>(Sum);
		}
		return true;
	}
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	{
		const uint32_t Inner = Program.Module.GetValueType(Step.I->Operands[0]).Count;
		const uint32_t Rows = SizeOf(Step, 0) / Inner;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Number Sum = At(0, Rows, i % Rows, 0) * At(1, Inner, 0, i / Rows);
			for (uint32_t k = 1; k < Inner; ++k)
			{
				Sum += At(0, Rows, i % Rows, k) * At(1, Inner, k, i / Rows);
			}
			Out[i] = ToSpirvWord<Number>(Sum);
		}
		return true;
	}
	case OpOuterProduct:
	{
		const uint32_t Rows = SizeOf(Step, 0);
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Out[i] = ToSpirvWord<Number>(GetValue<Number>(Step, 0, i % Rows) * GetValue<Number>(Step, 1, i / Rows));
		}
		return true;
	}
	case OpIAddCarry:
	case OpISubBorrow:
		for (uint32_t i = 0; i < Step.Size / 2; ++i)
		{
			const uint32_t Unused = 64 - 8 * GetSpirvBytes(Step.Kind);
			const FWord A = Value(Step, 0)[i] << Unused >> Unused;
			const FWord B = Value(Step, 1)[i] << Unused >> Unused;
			const FWord Made = (Step.I->Op == OpIAddCarry ? A + B : A - B) << Unused >> Unused;
			Out[i] = Made;
			Out[Step.Size / 2 + i] = Step.I->Op == OpIAddCarry ? Made < A : A < B;
		}
		return true;
	case OpAny:
	case OpAll:
	{
		bool bAny = false;
		bool bAll = true;
		for (uint32_t i = 0; i < SizeOf(Step, 0); ++i)
		{
			bAny = bAny || Bits(Step, 0, i);
			bAll = bAll && Bits(Step, 0, i);
		}
		Out[0] = Step.I->Op == OpAny ? bAny : bAll;
		return true;
	}
	default:
		return false;
	}
}

/** The bits of all components, the first one lowest, cut anew. */
template<typename Real>
void TSpirvThread<Real>::ExecuteBitcast(const FSpirvStep& Step)
{
	const uint32_t From = Program.Module.GetValueTypeId(Step.I->Operands[0]);
	uint8_t Bytes[64] = {};
	for (uint32_t i = 0; i < SizeOf(Step, 0); ++i)
	{
		const uint64_t Bits = ToSpirvMemory<Real>(GetKind(From, i), Value(Step, 0)[i]);
		const uint32_t Size = GetSpirvBytes(GetKind(From, i));
		std::memcpy(Bytes + i * Size, &Bits, Size);
	}
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		uint64_t Bits = 0;
		const uint32_t Size = GetSpirvBytes(GetKind(Step.I->Type, i));
		std::memcpy(&Bits, Bytes + i * Size, Size);
		Result(Step)[i] = FromSpirvMemory<Real>(GetKind(Step.I->Type, i), Bits);
	}
}

template<typename Real>
void TSpirvThread<Real>::Narrow(const FSpirvStep& Step, FWord* Out) const
{
	for (uint32_t i = 0; Step.bNarrow && i < Step.Size; ++i)
	{
		Out[i] = NarrowSpirv<Real>(GetKind(Step.I->Type, 0), Out[i]);
	}
}

/** An integer of 16 bits as the operation takes it, whatever its type says. */
template<typename Real>
TSpirvWord<Real> TSpirvThread<Real>::ViewOperand(const FSpirvStep& Step, bool bSigned, FWord Word)
{
	const bool bShort = Step.Kind == ESpirvType::Short || Step.Kind == ESpirvType::Ushort;
	return !bShort ? Word : NarrowSpirv<Real>(bSigned ? ESpirvType::Short : ESpirvType::Ushort, Word);
}

template<typename Real>
void TSpirvThread<Real>::ExecuteScalars(const FSpirvStep& Step)
{
	const uint16_t Op = Step.I->Op;
	const size_t Count = std::min<size_t>(Step.I->Operands.size(), 4);
	const bool bConverts = (Op >= OpConvertFToU && Op <= OpFConvert);
	const bool bSigned = Op == OpSDiv || Op == OpSRem || Op == OpSMod || Op == OpShiftRightArithmetic ||
						 Op == OpSGreaterThan || Op == OpSGreaterThanEqual || Op == OpSLessThan ||
						 Op == OpSLessThanEqual;
	const bool bShift = Op >= OpShiftRightLogical && Op <= OpShiftLeftLogical;
	const uint32_t Bits = 8 * GetSpirvBytes(Step.Kind);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		FWord Operands[4] = {};
		for (size_t k = 0; k < Count; ++k)
		{
			Operands[k] = ViewOperand(Step, bSigned, Value(Step, k)[SizeOf(Step, k) == 1 ? 0 : i]);
		}
		Operands[1] &= bShift ? FWord(Bits - 1) : ~FWord(0);
		FWord& Out = Result(Step)[i];
		bool bKnown = true;
		if (bConverts)
		{
			Out = ConvertSpirv<Real>(Op, Step.Kind, GetKind(Step.I->Type, i), Value(Step, 0)[i]);
		}
		else if (Step.Kind == ESpirvType::Long || Step.Kind == ESpirvType::Ulong)
		{
			bKnown = EvaluateLong(Op, Operands, Out);
		}
		else
		{
			bKnown = Step.Kind == ESpirvType::Double ? EvaluateOperation<double>(Op, Operands, Out)
													 : EvaluateOperation<Real>(Op, Operands, Out);
		}
		Out = Op == OpBitReverse && Bits == 16 ? Out >> 16 : Out;
		if (!bKnown)
		{
			Program.Module.Fail("the model does not know " + GetSpirvOpName(Op), Step.I);
		}
	}
}

} // namespace Drydock
