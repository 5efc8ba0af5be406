// Instructions on scalars, vectors and matrices, and the geometric functions.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"

#include <cmath>

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
bool TSpirvThread<Real>::ExecuteMatrix(const FSpirvStep& Step)
{
	// Element (Row, Column) of an operand that has Rows rows.
	const auto At = [this, &Step](size_t Operand, uint32_t Rows, uint32_t Row, uint32_t Column)
	{
		return GetValue(Step, Operand, Column * Rows + Row);
	};
	FWord* const Out = Step.Size ? Result(Step) : nullptr;
	switch (Step.I->Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			// The front end has them of integers too.
			Out[i] = IsReal(Step.I->Type, i) ? ToSpirvWord<Real>(GetValue(Step, 0, i) * GetValue(Step, 1, 0))
											 : FWord(Bits(Step, 0, i) * Bits(Step, 1, 0));
		}
		return true;
	case OpDot:
	case OpVectorTimesMatrix:
	{
		const uint32_t Rows = SizeOf(Step, 0);
		for (uint32_t Column = 0; Column < Step.Size; ++Column)
		{
			Real Sum = At(0, Rows, 0, 0) * At(1, Rows, 0, Column);
			for (uint32_t Row = 1; Row < Rows; ++Row)
			{
				Sum += At(0, Rows, Row, 0) * At(1, Rows, Row, Column);
			}
			Out[Column] = ToSpirvWord<Real>(Sum);
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
			Real Sum = At(0, Rows, i % Rows, 0) * At(1, Inner, 0, i / Rows);
			for (uint32_t k = 1; k < Inner; ++k)
			{
				Sum += At(0, Rows, i % Rows, k) * At(1, Inner, k, i / Rows);
			}
			Out[i] = ToSpirvWord<Real>(Sum);
		}
		return true;
	}
	case OpOuterProduct:
	{
		const uint32_t Rows = SizeOf(Step, 0);
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Out[i] = ToSpirvWord<Real>(GetValue(Step, 0, i % Rows) * GetValue(Step, 1, i / Rows));
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

template<typename Real>
void TSpirvThread<Real>::ExecuteBitcast(const FSpirvStep& Step)
{
	const uint32_t From = Program.Module.GetValueTypeId(Step.I->Operands[0]);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		// The bits that HLSL means are those of a float.
		const bool bFromReal = IsReal(From, i);
		const bool bToReal = IsReal(Step.I->Type, i);
		const FWord Word = Value(Step, 0)[i];
		const uint32_t Float =
			bFromReal ? __builtin_bit_cast(uint32_t, float(ToSpirvReal<Real>(Word))) : uint32_t(Word);
		Result(Step)[i] = bFromReal == bToReal ? Word
						  : bToReal            ? ToSpirvWord<Real>(Real(__builtin_bit_cast(float, Float)))
											   : FWord(Float);
	}
}

template<typename Real>
void TSpirvThread<Real>::ExecuteScalars(const FSpirvStep& Step)
{
	const size_t Count = std::min<size_t>(Step.I->Operands.size(), 3);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		FWord Operands[3] = {};
		for (size_t k = 0; k < Count; ++k)
		{
			Operands[k] = Value(Step, k)[SizeOf(Step, k) == 1 ? 0 : i];
		}
		if (!EvaluateOperation<Real>(Step.I->Op, Operands, Result(Step)[i]))
		{
			Program.Module.Fail("the model does not know " + GetSpirvOpName(Step.I->Op), Step.I);
		}
	}
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteGeometric(const FSpirvStep& Step)
{
	const uint32_t Size = SizeOf(Step, 2);
	const auto A = [this, &Step](uint32_t i)
	{
		return GetValue(Step, 2, i);
	};
	const auto B = [this, &Step](uint32_t i)
	{
		return GetValue(Step, 3, i);
	};
	const auto Dot = [Size](auto X, auto Y)
	{
		Real Sum = X(0) * Y(0);
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
		Out[0] = ToSpirvWord<Real>(GetDeterminant(Step));
		return true;
	case ExtLength:
		Out[0] = ToSpirvWord<Real>(Size == 1 ? std::fabs(A(0)) : std::sqrt(Dot(A, A)));
		return true;
	case ExtDistance:
	{
		const auto Difference = [&A, &B](uint32_t i)
		{
			return A(i) - B(i);
		};
		Out[0] = ToSpirvWord<Real>(Size == 1 ? std::fabs(Difference(0)) : std::sqrt(Dot(Difference, Difference)));
		return true;
	}
	case ExtNormalize:
	{
		const Real Inverse = Real(1) / std::sqrt(Dot(A, A));
		for (uint32_t i = 0; i < Size; ++i)
		{
			Out[i] = ToSpirvWord<Real>(Size == 1 ? Lanes::Sign(A(i)) : A(i) * Inverse);
		}
		return true;
	}
	case ExtCross:
		Out[0] = ToSpirvWord<Real>(A(1) * B(2) - A(2) * B(1));
		Out[1] = ToSpirvWord<Real>(A(2) * B(0) - A(0) * B(2));
		Out[2] = ToSpirvWord<Real>(A(0) * B(1) - A(1) * B(0));
		return true;
	case ExtReflect:
	{
		const Real Twice = Dot(B, A) + Dot(B, A);
		for (uint32_t i = 0; i < Size; ++i)
		{
			Out[i] = ToSpirvWord<Real>(A(i) - B(i) * Twice);
		}
		return true;
	}
	default:
		return Size == 4   ? ExecuteWithVectors<4>(Step)
			   : Size == 3 ? ExecuteWithVectors<3>(Step)
						   : ExecuteWithVectors<2>(Step);
	}
}

/** What has more than a line of arithmetic: the kernels' own functions. */
template<typename Real>
template<int Count>
bool TSpirvThread<Real>::ExecuteWithVectors(const FSpirvStep& Step)
{
	const auto Vector = [this, &Step](size_t Operand, uint32_t First = 0)
	{
		Lanes::TVec<Real, Count> Result;
		for (uint32_t i = 0; i < uint32_t(Count); ++i)
		{
			Result[int(i)] = GetValue(Step, Operand, First + i);
		}
		return Result;
	};
	const auto Give = [this, &Step](const Lanes::TVec<Real, Count>& Made)
	{
		for (uint32_t i = 0; i < uint32_t(Count); ++i)
		{
			Result(Step)[i] = ToSpirvWord<Real>(Made[int(i)]);
		}
		return true;
	};
	switch (Step.I->Operands[1])
	{
	case ExtRefract:
		return Give(Lanes::Refract(Vector(2), Vector(3), GetValue(Step, 4, 0)));
	case ExtFaceForward:
		return Give(Lanes::FaceForward(Vector(2), Vector(3), Vector(4)));
	default:
		return false;
	}
}

template<typename Real>
Real TSpirvThread<Real>::GetDeterminant(const FSpirvStep& Step)
{
	const auto Of = [this, &Step](auto Matrix)
	{
		const uint32_t Count = Program.Module.GetValueType(Step.I->Operands[2]).Count;
		for (uint32_t i = 0; i < Count * Count; ++i)
		{
			Matrix[int(i / Count)][int(i % Count)] = GetValue(Step, 2, i);
		}
		return Lanes::Determinant(Matrix);
	};
	switch (SizeOf(Step, 2))
	{
	case 4:
		return Of(Lanes::TMat<Real, 2, 2>());
	case 9:
		return Of(Lanes::TMat<Real, 3, 3>());
	default:
		return Of(Lanes::TMat<Real, 4, 4>());
	}
}

template<typename Real>
void TSpirvThread<Real>::ExecuteExtended(const FSpirvStep& Step)
{
	const uint32_t Ext = Step.I->Operands[1];
	if (ExecuteGeometric(Step))
	{
		return;
	}
	FWord* const Out = Result(Step);
	switch (Ext)
	{
	case ExtModf:
	{
		std::vector<FWord> Whole;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const Real Part = GetValue(Step, 2, i);
			Out[i] = ToSpirvWord<Real>(Part - std::trunc(Part));
			Whole.push_back(ToSpirvWord<Real>(std::trunc(Part)));
		}
		const uint32_t Pointer = uint32_t(Value(Step, 3)[0]);
		std::copy(Whole.begin(), Whole.end(), MemoryAt(Pointer));
		if (!Undefined.empty())
		{
			std::fill_n(Undefined.begin() + Pointer, Whole.size(), 0u);
		}
		return;
	}
	case ExtLdexp:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const bool bReal = IsReal(Program.Module.GetValueTypeId(Step.I->Operands[3]), i);
			const Real X = GetValue(Step, 2, i);
			Out[i] = ToSpirvWord<Real>(
				bReal ? X * Lanes::Exp2(GetValue(Step, 3, i)) : Lanes::Ldexp(X, int32_t(Bits(Step, 3, i))));
		}
		return;
	case ExtPackHalf2x16:
		Out[0] = Lanes::PackHalf2(Lanes::TVec<Real, 2>(GetValue(Step, 2, 0), GetValue(Step, 2, 1)));
		return;
	case ExtUnpackHalf2x16:
	{
		const Lanes::TVec<Real, 2> Both = Lanes::UnpackHalf2<Real>(Bits(Step, 2));
		Out[0] = ToSpirvWord<Real>(Both[0]);
		Out[1] = ToSpirvWord<Real>(Both[1]);
		return;
	}
	default:
		break;
	}
	const size_t Count = std::min<size_t>(Step.I->Operands.size(), 5);
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		FWord Operands[3] = {};
		for (size_t k = 2; k < Count; ++k)
		{
			Operands[k - 2] = Value(Step, k)[i];
		}
		if (!EvaluateExtended<Real>(Ext, Operands, Out[i]))
		{
			Program.Module.Fail("the model does not know GLSL.std.450 instruction " + std::to_string(Ext), Step.I);
		}
	}
}

} // namespace Drydock
