// Wave operations of the threads of a wave that wait at the same one. The same rules as in LanesWaves.h.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"

#include <limits>

namespace Drydock
{

using namespace Spirv;

namespace Waves
{

/** Combines two integers as SPIR-V's wave arithmetic does. T: uint32_t or uint64_t. */
template<typename T>
T CombineIntegers(uint16_t Op, T A, T B)
{
	using FSigned = std::make_signed_t<T>;
	switch (Op)
	{
	case OpGroupNonUniformIAdd:
		return A + B;
	case OpGroupNonUniformIMul:
		return A * B;
	case OpGroupNonUniformSMin:
		return FSigned(A) < FSigned(B) ? A : B;
	case OpGroupNonUniformUMin:
		return std::min(A, B);
	case OpGroupNonUniformSMax:
		return FSigned(A) > FSigned(B) ? A : B;
	case OpGroupNonUniformUMax:
		return std::max(A, B);
	case OpGroupNonUniformBitwiseAnd:
		return A & B;
	case OpGroupNonUniformBitwiseOr:
		return A | B;
	default:
		return A ^ B;
	}
}

/** Combines two numbers; words of reals are reals. */
template<typename Real>
TSpirvWord<Real> Combine(uint16_t Op, TSpirvWord<Real> A, TSpirvWord<Real> B)
{
	const Real X = ToSpirvReal<Real>(A);
	const Real Y = ToSpirvReal<Real>(B);
	switch (Op)
	{
	case OpGroupNonUniformFAdd:
		return ToSpirvWord<Real>(X + Y);
	case OpGroupNonUniformFMul:
		return ToSpirvWord<Real>(X * Y);
	case OpGroupNonUniformFMin:
		return ToSpirvWord<Real>(Lanes::Min(X, Y));
	case OpGroupNonUniformFMax:
		return ToSpirvWord<Real>(Lanes::Max(X, Y));
	default:
		return TSpirvWord<Real>(CombineIntegers(Op, uint32_t(A), uint32_t(B)));
	}
}

template<typename T>
T GetIntegerIdentity(uint16_t Op)
{
	constexpr T SignedMax = T(std::numeric_limits<std::make_signed_t<T>>::max());
	switch (Op)
	{
	case OpGroupNonUniformIMul:
		return 1;
	case OpGroupNonUniformSMin:
		return SignedMax;
	case OpGroupNonUniformUMin:
	case OpGroupNonUniformBitwiseAnd:
		return T(-1);
	case OpGroupNonUniformSMax:
		return SignedMax + 1;
	default:
		return 0;
	}
}

template<typename Real>
TSpirvWord<Real> GetIdentity(uint16_t Op)
{
	constexpr Real Infinity = std::numeric_limits<Real>::infinity();
	switch (Op)
	{
	case OpGroupNonUniformFAdd:
		return ToSpirvWord<Real>(Real(0));
	case OpGroupNonUniformFMul:
		return ToSpirvWord<Real>(Real(1));
	case OpGroupNonUniformFMin:
		return ToSpirvWord<Real>(Infinity);
	case OpGroupNonUniformFMax:
		return ToSpirvWord<Real>(-Infinity);
	default:
		return TSpirvWord<Real>(GetIntegerIdentity<uint32_t>(Op));
	}
}

/** By what the shader's numbers are. */
template<typename Real>
TSpirvWord<Real> CombineOf(ESpirvType Kind, uint16_t Op, TSpirvWord<Real> A, TSpirvWord<Real> B)
{
	if (Kind == ESpirvType::Double)
	{
		return Combine<double>(Op, A, B);
	}
	if (Kind != ESpirvType::Long && Kind != ESpirvType::Ulong)
	{
		return Combine<Real>(Op, A, B);
	}
	return CombineIntegers<uint64_t>(Op, A, B);
}

template<typename Real>
TSpirvWord<Real> GetIdentityOf(ESpirvType Kind, uint16_t Op)
{
	return Kind == ESpirvType::Long || Kind == ESpirvType::Ulong ? GetIntegerIdentity<uint64_t>(Op)
		   : Kind == ESpirvType::Double                          ? GetIdentity<double>(Op)
																 : GetIdentity<Real>(Op);
}

} // namespace Waves

/** Arithmetic over all threads, or over those before each. It gives a result for each thread. */
template<typename Real>
auto TSpirvThread<Real>::CombineWave(const std::vector<TSpirvThread*>& Together) -> std::vector<FWaveResult>
{
	const FSpirvStep& Step = Together.front()->GetWaiting();
	const uint16_t Op = Step.I->Op;
	const bool bReduce = Step.I->Operands[1] == 0;
	FWaveResult Sum(Step.Size);
	std::optional<FScopedDenormals> Doubles;
	if (sizeof(Real) == 4 && Step.Kind == ESpirvType::Double)
	{
		Doubles.emplace(EDenormals::Keep); // where floats flush them
	}
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		Sum[i] = bReduce ? Together.front()->Value(Step, 2)[i] : Waves::GetIdentityOf<Real>(Step.Kind, Op);
	}
	std::vector<FWaveResult> Results;
	for (const TSpirvThread* const Thread : Together)
	{
		if (!bReduce)
		{
			Results.push_back(Sum); // of the threads before this one
		}
		for (uint32_t i = 0; i < Step.Size && !(bReduce && Thread == Together.front()); ++i)
		{
			Sum[i] = Waves::CombineOf<Real>(Step.Kind, Op, Sum[i], Thread->Value(Step, 2)[i]);
		}
	}
	if (bReduce)
	{
		Results.assign(Together.size(), Sum);
	}
	return Results;
}

/** Whether the threads have the same operand, number by number. */
template<typename Real>
bool TSpirvThread<Real>::AgreesWith(const TSpirvThread& Other) const
{
	const FSpirvStep& Step = GetWaiting();
	const uint32_t Type = Program.Module.GetValueTypeId(Step.I->Operands[1]);
	for (uint32_t i = 0; i < SizeOf(Step, 1); ++i)
	{
		const FWord A = Value(Step, 1)[i];
		const FWord B = Other.Value(Step, 1)[i];
		const bool bSame = Step.Kind == ESpirvType::Double ? ToSpirvReal<double>(A) == ToSpirvReal<double>(B)
						   : IsReal(Type, i)               ? ToSpirvReal<Real>(A) == ToSpirvReal<Real>(B)
														   : A == B;
		if (!bSame)
		{
			return false;
		}
	}
	return true;
}

/** An answer that is the same for all threads: a vote or the first one's value. Empty: the operation is another one. */
template<typename Real>
auto TSpirvThread<Real>::AskWave(const std::vector<TSpirvThread*>& Together) -> FWaveResult
{
	const TSpirvThread& First = *Together.front();
	const FSpirvStep& Step = First.GetWaiting();
	const auto Votes = [&Step](const TSpirvThread* Thread)
	{
		return Thread->Bits(Step, 1) != 0;
	};
	FWaveResult Result(Step.Size);
	switch (Step.I->Op)
	{
	case OpGroupNonUniformAll:
		Result[0] = std::all_of(Together.begin(), Together.end(), Votes);
		return Result;
	case OpGroupNonUniformAny:
		Result[0] = std::any_of(Together.begin(), Together.end(), Votes);
		return Result;
	case OpGroupNonUniformAllEqual:
		Result[0] = std::all_of(Together.begin(), Together.end(),
			[&First](const TSpirvThread* Thread) { return First.AgreesWith(*Thread); });
		return Result;
	case OpGroupNonUniformBallot:
		for (const TSpirvThread* const Thread : Together)
		{
			Result[Thread->Lane / 32] |= FWord(Votes(Thread)) << Thread->Lane % 32;
		}
		return Result;
	case OpGroupNonUniformBroadcastFirst:
		std::copy_n(First.Value(Step, 1), Step.Size, Result.begin());
		return Result;
	default:
		return {};
	}
}

/** An answer that depends on the thread's own lane or index. A lane that is not among the threads gives 0. */
template<typename Real>
auto TSpirvThread<Real>::ReadInWave(const std::vector<TSpirvThread*>& Together) const -> FWaveResult
{
	const FSpirvStep& Step = GetWaiting();
	const FSpirvInstruction& I = *Step.I;
	const uint32_t Index = I.Operands.size() > 2 && SizeOf(Step, 2) ? Bits(Step, 2) : 0;
	FWaveResult Result(Step.Size);
	const auto Read = [&](uint32_t From)
	{
		const auto Source = std::find_if(
			Together.begin(), Together.end(), [From](const TSpirvThread* Thread) { return Thread->Lane == From; });
		if (Source != Together.end())
		{
			std::copy_n((*Source)->Value(Step, 1), Step.Size, Result.begin());
		}
	};
	switch (I.Op)
	{
	case OpGroupNonUniformElect:
		Result[0] = this == Together.front();
		break;
	case OpGroupNonUniformBallotBitCount:
	{
		const uint64_t Ballot = uint64_t(Bits(Step, 2, 1)) << 32 | Bits(Step, 2, 0);
		const uint64_t Before = I.Operands[1] == 0 ? ~uint64_t(0) : (uint64_t(1) << Lane) - 1;
		Result[0] = FWord(__builtin_popcountll(Ballot & Before));
		break;
	}
	case OpGroupNonUniformQuadBroadcast:
		Read((Lane & ~3u) | (Index & 3));
		break;
	case OpGroupNonUniformQuadSwap:
		Read(Lane ^ (Index + 1));
		break;
	case OpGroupNonUniformBroadcast:
	case OpGroupNonUniformShuffle:
		Read(Index);
		break;
	default:
		break;
	}
	return Result;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteTogether(const std::vector<TSpirvThread*>& Together)
{
	const FSpirvStep& Step = Together.front()->GetWaiting();
	const uint16_t Op = Step.I->Op;
	if (!IsSpirvWave(Op))
	{
		ExecuteQuad(Together);
		return;
	}
	std::vector<FWaveResult> Results;
	if (Op >= OpGroupNonUniformIAdd && Op <= OpGroupNonUniformBitwiseXor)
	{
		Results = CombineWave(Together);
	}
	else if (FWaveResult Same = AskWave(Together); !Same.empty())
	{
		Results.assign(Together.size(), Same);
	}
	else
	{
		for (const TSpirvThread* const Thread : Together)
		{
			Results.push_back(Thread->ReadInWave(Together));
		}
	}
	for (size_t i = 0; i < Together.size(); ++i)
	{
		Together[i]->Narrow(Step, Results[i].data());
		std::copy(Results[i].begin(), Results[i].end(), Together[i]->Result(Step));
		Together[i]->Note(Step);
		Together[i]->ShowWaiting();
	}
}

} // namespace Drydock
