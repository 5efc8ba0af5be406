// The functions of GLSL.std.450. Source: Khronos, SPIR-V extended instructions for GLSL.
#pragma once

#include "SpirvFlow.h"
#include "SpirvThread.h"

#include "Lanes.h"

#include <cmath>

namespace Drydock
{

using namespace Spirv;

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
	const uint32_t Size = SizeOf(Step, 2);
	const FSpirvNorms* const Norms = FindSpirvNorms(Ext);
	for (uint32_t i = 0; Norms && i < Norms->Count; ++i)
	{
		const uint32_t Shift = i * Norms->GetBits();
		const Number One = Number(Norms->GetOne());
		const Number Least = Number(Norms->bSigned ? -1 : 0);
		if (Norms->bPacks)
		{
			const Number Clamped = Lanes::Clamp(GetValue<Number>(Step, 2, i), Least, Number(1));
			const uint32_t Code = uint32_t(int32_t(std::nearbyint(Clamped * One)));
			Out[0] = (i ? Out[0] : 0) | FWord(uint32_t(Code << (32 - Norms->GetBits())) >> (32 - Norms->GetBits()))
											<< Shift;
			continue;
		}
		const uint32_t High = Bits(Step, 2) << (32 - Norms->GetBits() - Shift); // the code in the highest bits
		const int64_t Code =
			Norms->bSigned ? int32_t(High) >> (32 - Norms->GetBits()) : int64_t(High >> (32 - Norms->GetBits()));
		Out[i] = ToSpirvWord<Number>(std::max(Number(Code) / One, Least));
	}
	if (Norms)
	{
		return true;
	}
	switch (Ext)
	{
	case ExtFrexpStruct:
		for (uint32_t i = 0; i < Size; ++i)
		{
			const Lanes::TVec<Number, 2> Parts = Lanes::Frexp(GetValue<Number>(Step, 2, i));
			Out[i] = ToSpirvWord<Number>(Parts[0]);
			Out[Size + i] = uint32_t(int32_t(Parts[1]));
		}
		return true;
	case ExtModf:
	case ExtModfStruct:
	{
		std::vector<FWord> Whole;
		for (uint32_t i = 0; i < Size; ++i)
		{
			const Number Part = GetValue<Number>(Step, 2, i);
			Out[i] = ToSpirvWord<Number>(Part - std::trunc(Part));
			Whole.push_back(ToSpirvWord<Number>(std::trunc(Part)));
		}
		if (Ext == ExtModfStruct)
		{
			std::copy(Whole.begin(), Whole.end(), Out + Size);
			return true;
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
