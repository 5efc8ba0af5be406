// Instructions on scalars, vectors and matrices, and the geometric functions. A little past 500 lines: the switches
// share their helpers.
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
	const size_t Count = std::min<size_t>(Step.I->Operands.size(), 3);
	const bool bConverts = (Op >= OpConvertFToU && Op <= OpFConvert);
	const bool bSigned = Op == OpSDiv || Op == OpSRem || Op == OpSMod || Op == OpShiftRightArithmetic ||
						 Op == OpSGreaterThan || Op == OpSGreaterThanEqual || Op == OpSLessThan ||
						 Op == OpSLessThanEqual;
	const bool bShift = Op >= OpShiftRightLogical && Op <= OpShiftLeftLogical;
	const uint32_t Bits = 8 * GetSpirvBytes(Step.Kind);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		FWord Operands[3] = {};
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

template<typename Real>
template<typename Number>
bool TSpirvThread<Real>::ExecuteGeometric(const FSpirvStep& Step)
{
	const uint32_t Size = SizeOf(Step, 2);
	const auto A = [this, &Step](uint32_t i)
	{
		return GetValue<Number>(Step, 2, i);
	};
	const auto B = [this, &Step](uint32_t i)
	{
		return GetValue<Number>(Step, 3, i);
	};
	const auto Dot = [Size](auto X, auto Y)
	{
		Number Sum = X(0) * Y(0);
		for (uint32_t i = 1; i < Size; ++i)
		{
			Sum += X(i) * Y(i);
		}
		return Sum;
	};
	FWord* const Out = Result(Step);
	switch (Step.I->Operands[1])
	{
	case ExtDeterminant:
		Out[0] = ToSpirvWord<Number>(GetDeterminant<Number>(Step));
		return true;
	case ExtLength:
		Out[0] = ToSpirvWord<Number>(Size == 1 ? std::fabs(A(0)) : std::sqrt(Dot(A, A)));
		return true;
	case ExtDistance:
	{
		const auto Difference = [&A, &B](uint32_t i)
		{
			return A(i) - B(i);
		};
		Out[0] = ToSpirvWord<Number>(Size == 1 ? std::fabs(Difference(0)) : std::sqrt(Dot(Difference, Difference)));
		return true;
	}
	case ExtNormalize:
	{
		const Number Inverse = Number(1) / std::sqrt(Dot(A, A));
		for (uint32_t i = 0; i < Size; ++i)
		{
			Out[i] = ToSpirvWord<Number>(Size == 1 ? Lanes::Sign(A(i)) : A(i) * Inverse);
		}
		return true;
	}
	case ExtCross:
		Out[0] = ToSpirvWord<Number>(A(1) * B(2) - A(2) * B(1));
		Out[1] = ToSpirvWord<Number>(A(2) * B(0) - A(0) * B(2));
		Out[2] = ToSpirvWord<Number>(A(0) * B(1) - A(1) * B(0));
		return true;
	case ExtReflect:
	{
		const Number Twice = Dot(B, A) + Dot(B, A);
		for (uint32_t i = 0; i < Size; ++i)
		{
			Out[i] = ToSpirvWord<Number>(A(i) - B(i) * Twice);
		}
		return true;
	}
	default:
		return Size == 4   ? ExecuteWithVectors<Number, 4>(Step)
			   : Size == 3 ? ExecuteWithVectors<Number, 3>(Step)
						   : ExecuteWithVectors<Number, 2>(Step);
	}
}

/** Executes operations of more than a line of arithmetic by the kernels' own functions. */
template<typename Real>
template<typename Number, int Count>
bool TSpirvThread<Real>::ExecuteWithVectors(const FSpirvStep& Step)
{
	const auto Vector = [this, &Step](size_t Operand, uint32_t First = 0)
	{
		Lanes::TVec<Number, Count> Result;
		for (uint32_t i = 0; i < uint32_t(Count); ++i)
		{
			Result[int(i)] = GetValue<Number>(Step, Operand, First + i);
		}
		return Result;
	};
	const auto Give = [this, &Step](const Lanes::TVec<Number, Count>& Made)
	{
		for (uint32_t i = 0; i < uint32_t(Count); ++i)
		{
			Result(Step)[i] = ToSpirvWord<Number>(Made[int(i)]);
		}
		return true;
	};
	switch (Step.I->Operands[1])
	{
	case ExtRefract:
		return Give(Lanes::Refract(Vector(2), Vector(3), GetValue<Number>(Step, 4, 0)));
	case ExtFaceForward:
		return Give(Lanes::FaceForward(Vector(2), Vector(3), Vector(4)));
	default:
		return false;
	}
}

template<typename Real>
template<typename Number>
Number TSpirvThread<Real>::GetDeterminant(const FSpirvStep& Step)
{
	const auto Of = [this, &Step](auto Matrix)
	{
		const uint32_t Count = Program.Module.GetValueType(Step.I->Operands[2]).Count;
		for (uint32_t i = 0; i < Count * Count; ++i)
		{
			Matrix[int(i / Count)][int(i % Count)] = GetValue<Number>(Step, 2, i);
		}
		return Lanes::Determinant(Matrix);
	};
	switch (SizeOf(Step, 2))
	{
	case 4:
		return Of(Lanes::TMat<Number, 2, 2>());
	case 9:
		return Of(Lanes::TMat<Number, 3, 3>());
	default:
		return Of(Lanes::TMat<Number, 4, 4>());
	}
}

/** Functions that are not computed component by component; false: it is one that is. */
template<typename Real>
template<typename Number>
bool TSpirvThread<Real>::ExecuteWhole(const FSpirvStep& Step)
{
	const uint32_t Ext = Step.I->Operands[1];
	if (ExecuteGeometric<Number>(Step))
	{
		return true;
	}
	FWord* const Out = Result(Step);
	switch (Ext)
	{
	case ExtModf:
	{
		std::vector<FWord> Whole;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const Number Part = GetValue<Number>(Step, 2, i);
			Out[i] = ToSpirvWord<Number>(Part - std::trunc(Part));
			Whole.push_back(ToSpirvWord<Number>(std::trunc(Part)));
		}
		const uint32_t Pointer = uint32_t(Value(Step, 3)[0]);
		std::copy(Whole.begin(), Whole.end(), MemoryAt(Step, Pointer, uint32_t(Whole.size())));
		if (!Undefined.empty())
		{
			std::fill_n(Undefined.begin() + Pointer, Whole.size(), 0u);
		}
		return true;
	}
	case ExtLdexp:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const bool bReal = IsReal(Program.Module.GetValueTypeId(Step.I->Operands[3]), i);
			const Number X = GetValue<Number>(Step, 2, i);
			Out[i] = ToSpirvWord<Number>(
				bReal ? X * Lanes::Exp2(GetValue<Number>(Step, 3, i)) : Lanes::Ldexp(X, int32_t(Bits(Step, 3, i))));
		}
		return true;
	case ExtPackDouble2x32:
		Out[0] = FWord(Bits(Step, 2, 1)) << 32 | Bits(Step, 2, 0);
		return true;
	case ExtUnpackDouble2x32:
		Out[0] = Bits(Step, 2);
		Out[1] = Value(Step, 2)[0] >> 32;
		return true;
	case ExtPackHalf2x16:
		Out[0] = Lanes::PackHalf2(Lanes::TVec<Number, 2>(GetValue<Number>(Step, 2, 0), GetValue<Number>(Step, 2, 1)));
		return true;
	case ExtUnpackHalf2x16:
	{
		const Lanes::TVec<Number, 2> Both = Lanes::UnpackHalf2<Number>(Bits(Step, 2));
		Out[0] = ToSpirvWord<Number>(Both[0]);
		Out[1] = ToSpirvWord<Number>(Both[1]);
		return true;
	}
	default:
		return false;
	}
}

template<typename Real>
void TSpirvThread<Real>::ExecuteExtended(const FSpirvStep& Step)
{
	const uint32_t Ext = Step.I->Operands[1];
	const bool bDouble = Step.Kind == ESpirvType::Double;
	if (bDouble ? ExecuteWhole<double>(Step) : ExecuteWhole<Real>(Step))
	{
		return;
	}
	const bool bLong = Step.Kind == ESpirvType::Long || Step.Kind == ESpirvType::Ulong;
	const bool bSigned = Ext != ExtUMin && Ext != ExtUMax && Ext != ExtUClamp && Ext != ExtFindUMsb;
	FWord* const Out = Result(Step);
	const size_t Count = std::min<size_t>(Step.I->Operands.size(), 5);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		FWord Operands[3] = {};
		for (size_t k = 2; k < Count; ++k)
		{
			Operands[k - 2] = ViewOperand(Step, bSigned, Value(Step, k)[i]);
		}
		if (Step.Kind == ESpirvType::Half && Ext == ExtFma)
		{
			// The optimiser makes this of a product and a sum: both are rounded.
			const Real Product = ToSpirvReal<Real>(Operands[0]) * ToSpirvReal<Real>(Operands[1]);
			Operands[0] = NarrowSpirv<Real>(Step.Kind, ToSpirvWord<Real>(Product));
			Operands[1] = ToSpirvWord<Real>(Real(1));
		}
		const bool bKnown = bDouble ? EvaluateExtended<double>(Ext, Operands, Out[i])
							: bLong ? EvaluateExtendedLong(Ext, Operands, Out[i])
									: EvaluateExtended<Real>(Ext, Operands, Out[i]);
		if (!bKnown)
		{
			Program.Module.Fail("the model does not know GLSL.std.450 instruction " + std::to_string(Ext), Step.I);
		}
	}
}

} // namespace Drydock
