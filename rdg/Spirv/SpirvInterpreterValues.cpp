// Runs the instructions on vectors and matrices and the geometric functions in the model.
#include "SpirvInterpreterImpl.h"

#include <cmath>

namespace Drydock
{

using namespace Spirv;

bool FSpirvInterpreterImpl::ExecuteComposite(const FSpirvInstruction& I, FScalars& Result)
{
	switch (I.Op)
	{
	case OpVectorShuffle:
	{
		FScalars Both = Get(I.Operands[0]);
		const FScalars& Second = Get(I.Operands[1]);
		Both.insert(Both.end(), Second.begin(), Second.end());
		for (size_t i = 2; i < I.Operands.size(); ++i)
		{
			Result.push_back(I.Operands[i] == ~0u ? 0 : Both[I.Operands[i]]);
		}
		return true;
	}
	case OpCompositeConstruct:
		for (const uint32_t Part : I.Operands)
		{
			const FScalars& Value = Get(Part);
			Result.insert(Result.end(), Value.begin(), Value.end());
		}
		return true;
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const size_t Composite = I.Op == OpCompositeInsert ? 1 : 0;
		const auto [Offset, Type] = Module.FindPart(Module.GetValueTypeId(I.Operands[Composite]),
			I.Operands.data() + Composite + 1, I.Operands.data() + I.Operands.size());
		const FScalars Whole = Get(I.Operands[Composite]);
		if (I.Op == OpCompositeExtract)
		{
			Result.assign(Whole.begin() + Offset, Whole.begin() + Offset + Module.GetType(Type).NumScalars);
			return true;
		}
		const FScalars& Part = Get(I.Operands[0]);
		Result = Whole;
		std::copy(Part.begin(), Part.end(), Result.begin() + Offset);
		return true;
	}
	case OpVectorExtractDynamic:
	{
		const FScalars& Vector = Get(I.Operands[0]);
		Result = {Vector[std::min<size_t>(Get(I.Operands[1])[0], Vector.size() - 1)]};
		return true;
	}
	case OpVectorInsertDynamic:
	{
		Result = Get(I.Operands[0]);
		const uint32_t Index = Get(I.Operands[2])[0];
		if (Index < Result.size())
		{
			Result[Index] = Get(I.Operands[1])[0];
		}
		return true;
	}
	default:
		return false;
	}
}

bool FSpirvInterpreterImpl::ExecuteMatrix(const FSpirvInstruction& I, FScalars& Result)
{
	// Element (Row, Column) of an operand that has Rows rows.
	const auto At = [this, &I](size_t Operand, uint32_t Rows, uint32_t Row, uint32_t Column)
	{
		return GetFloat(I.Operands[Operand], Column * Rows + Row);
	};
	const uint32_t Size = I.Type ? Module.GetType(I.Type).NumScalars : 0; // image writes have no result
	const auto Count = [this, &I](size_t Operand)
	{
		return Module.GetValueType(I.Operands[Operand]).NumScalars;
	};
	switch (I.Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(ToBits(GetFloat(I.Operands[0], i) * GetFloat(I.Operands[1], 0)));
		}
		return true;
	case OpDot:
	case OpVectorTimesMatrix:
	{
		const uint32_t Rows = Count(0);
		for (uint32_t Column = 0; Column < Size; ++Column)
		{
			float Sum = At(0, Rows, 0, 0) * At(1, Rows, 0, Column);
			for (uint32_t Row = 1; Row < Rows; ++Row)
			{
				Sum += At(0, Rows, Row, 0) * At(1, Rows, Row, Column);
			}
			Result.push_back(ToBits(Sum));
		}
		return true;
	}
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	{
		const uint32_t Inner = Module.GetValueType(I.Operands[0]).Count;
		const uint32_t Rows = Count(0) / Inner;
		for (uint32_t i = 0; i < Size; ++i)
		{
			float Sum = At(0, Rows, i % Rows, 0) * At(1, Inner, 0, i / Rows);
			for (uint32_t k = 1; k < Inner; ++k)
			{
				Sum += At(0, Rows, i % Rows, k) * At(1, Inner, k, i / Rows);
			}
			Result.push_back(ToBits(Sum));
		}
		return true;
	}
	case OpOuterProduct:
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(ToBits(GetFloat(I.Operands[0], i % Count(0)) * GetFloat(I.Operands[1], i / Count(0))));
		}
		return true;
	case OpTranspose:
	{
		const uint32_t Columns = Module.GetType(I.Type).Count;
		const uint32_t Rows = Size / Columns;
		for (uint32_t i = 0; i < Size; ++i)
		{
			Result.push_back(Get(I.Operands[0])[(i % Rows) * Columns + i / Rows]);
		}
		return true;
	}
	case OpAny:
	case OpAll:
	{
		const FScalars& Value = Get(I.Operands[0]);
		const auto IsSet = [](uint32_t Bits)
		{
			return Bits != 0;
		};
		Result = {uint32_t(I.Op == OpAny ? std::any_of(Value.begin(), Value.end(), IsSet)
										 : std::all_of(Value.begin(), Value.end(), IsSet))};
		return true;
	}
	default:
		return false;
	}
}

void FSpirvInterpreterImpl::ExecuteExtended(const FSpirvInstruction& I, FScalars& Result)
{
	const uint32_t Ext = I.Operands[1];
	const auto Vector = [this, &I](size_t Operand)
	{
		std::vector<float> Value;
		for (const uint32_t Bits : Get(I.Operands[Operand]))
		{
			Value.push_back(ToFloat(Bits));
		}
		return Value;
	};
	const auto Dot = [](const std::vector<float>& A, const std::vector<float>& B)
	{
		float Sum = A[0] * B[0];
		for (size_t i = 1; i < A.size(); ++i)
		{
			Sum += A[i] * B[i];
		}
		return Sum;
	};
	const auto Push = [&Result](float Value)
	{
		Result.push_back(ToBits(Value));
	};
	const std::vector<float> A = Vector(2);
	switch (Ext)
	{
	case ExtLength:
		Push(A.size() == 1 ? std::fabs(A[0]) : std::sqrt(Dot(A, A)));
		return;
	case ExtDistance:
	{
		std::vector<float> Difference = Vector(3);
		for (size_t i = 0; i < A.size(); ++i)
		{
			Difference[i] = A[i] - Difference[i];
		}
		Push(A.size() == 1 ? std::fabs(Difference[0]) : std::sqrt(Dot(Difference, Difference)));
		return;
	}
	case ExtNormalize:
		for (const float Part : A)
		{
			Push(A.size() == 1 ? Lanes::Sign(Part) : Part * (1.0f / std::sqrt(Dot(A, A))));
		}
		return;
	case ExtCross:
	{
		const std::vector<float> B = Vector(3);
		Push(A[1] * B[2] - A[2] * B[1]);
		Push(A[2] * B[0] - A[0] * B[2]);
		Push(A[0] * B[1] - A[1] * B[0]);
		return;
	}
	case ExtReflect:
	{
		const std::vector<float> Normal = Vector(3);
		const float Twice = Dot(Normal, A) + Dot(Normal, A);
		for (size_t i = 0; i < A.size(); ++i)
		{
			Push(A[i] - Normal[i] * Twice);
		}
		return;
	}
	case ExtModf:
	{
		FScalars Whole;
		for (const float Part : A)
		{
			Push(Part - std::trunc(Part));
			Whole.push_back(ToBits(std::trunc(Part)));
		}
		Store(I.Operands[3], Whole);
		return;
	}
	case ExtLdexp:
		for (uint32_t i = 0; i < A.size(); ++i)
		{
			const bool bFloat = Module.GetScalarKind(Module.GetValueTypeId(I.Operands[3]), i) == ESpirvType::Float;
			Push(bFloat ? A[i] * Lanes::Exp2(GetFloat(I.Operands[3], i))
						: Lanes::Ldexp(A[i], int32_t(Get(I.Operands[3])[i])));
		}
		return;
	case ExtPackHalf2x16:
		Result.push_back(Lanes::PackHalf2(Lanes::TVec<float, 2>(A[0], A[1])));
		return;
	case ExtUnpackHalf2x16:
	{
		const Lanes::TVec<float, 2> Both = Lanes::UnpackHalf2<float>(Get(I.Operands[2])[0]);
		Push(Both[0]);
		Push(Both[1]);
		return;
	}
	default:
		break;
	}
	for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
	{
		uint32_t Operands[3] = {};
		for (size_t k = 2; k < I.Operands.size() && k < 5; ++k)
		{
			Operands[k - 2] = Get(I.Operands[k])[i];
		}
		uint32_t Bits = 0;
		if (!EvaluateExtended(Ext, Operands, Bits))
		{
			Module.Fail("the model does not know GLSL.std.450 instruction " + std::to_string(Ext), &I);
		}
		Result.push_back(Bits);
	}
}

} // namespace Drydock
