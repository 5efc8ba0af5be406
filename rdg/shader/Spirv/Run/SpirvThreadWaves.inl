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

/** Combines two numbers as SPIR-V's wave arithmetic does; words of reals are reals. */
template<typename Real>
TSpirvWord<Real> Combine(uint16_t Op, TSpirvWord<Real> A, TSpirvWord<Real> B)
{
	using FWord = TSpirvWord<Real>;
	const Real X = ToSpirvReal<Real>(A);
	const Real Y = ToSpirvReal<Real>(B);
	const uint32_t P = uint32_t(A);
	const uint32_t Q = uint32_t(B);
	switch (Op)
	{
	case OpGroupNonUniformIAdd:
		return FWord(P + Q);
	case OpGroupNonUniformFAdd:
		return ToSpirvWord<Real>(X + Y);
	case OpGroupNonUniformIMul:
		return FWord(P * Q);
	case OpGroupNonUniformFMul:
		return ToSpirvWord<Real>(X * Y);
	case OpGroupNonUniformSMin:
		return FWord(int32_t(P) < int32_t(Q) ? P : Q);
	case OpGroupNonUniformUMin:
		return FWord(std::min(P, Q));
	case OpGroupNonUniformFMin:
		return ToSpirvWord<Real>(Lanes::Min(X, Y));
	case OpGroupNonUniformSMax:
		return FWord(int32_t(P) > int32_t(Q) ? P : Q);
	case OpGroupNonUniformUMax:
		return FWord(std::max(P, Q));
	case OpGroupNonUniformFMax:
		return ToSpirvWord<Real>(Lanes::Max(X, Y));
	case OpGroupNonUniformBitwiseAnd:
		return FWord(P & Q);
	case OpGroupNonUniformBitwiseOr:
		return FWord(P | Q);
	default:
		return FWord(P ^ Q);
	}
}

template<typename Real>
TSpirvWord<Real> GetIdentity(uint16_t Op)
{
	using FWord = TSpirvWord<Real>;
	constexpr Real Infinity = std::numeric_limits<Real>::infinity();
	switch (Op)
	{
	case OpGroupNonUniformFAdd:
		return ToSpirvWord<Real>(Real(0));
	case OpGroupNonUniformIMul:
		return FWord(1);
	case OpGroupNonUniformFMul:
		return ToSpirvWord<Real>(Real(1));
	case OpGroupNonUniformSMin:
		return FWord(0x7FFFFFFFu);
	case OpGroupNonUniformUMin:
	case OpGroupNonUniformBitwiseAnd:
		return FWord(~0u);
	case OpGroupNonUniformFMin:
		return ToSpirvWord<Real>(Infinity);
	case OpGroupNonUniformSMax:
		return FWord(0x80000000u);
	case OpGroupNonUniformFMax:
		return ToSpirvWord<Real>(-Infinity);
	default:
		return FWord(0);
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
	switch (Op)
	{
	case OpGroupNonUniformIAdd:
		return A + B;
	case OpGroupNonUniformIMul:
		return A * B;
	case OpGroupNonUniformSMin:
		return int64_t(A) < int64_t(B) ? A : B;
	case OpGroupNonUniformUMin:
		return std::min(A, B);
	case OpGroupNonUniformSMax:
		return int64_t(A) > int64_t(B) ? A : B;
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

template<typename Real>
TSpirvWord<Real> GetIdentityOf(ESpirvType Kind, uint16_t Op)
{
	const bool bLong = Kind == ESpirvType::Long || Kind == ESpirvType::Ulong;
	switch (bLong ? Op : 0)
	{
	case OpGroupNonUniformSMin:
		return uint64_t(std::numeric_limits<int64_t>::max());
	case OpGroupNonUniformUMin:
	case OpGroupNonUniformBitwiseAnd:
		return ~uint64_t(0);
	case OpGroupNonUniformSMax:
		return uint64_t(1) << 63;
	default:
		return Kind == ESpirvType::Double ? GetIdentity<double>(Op) : GetIdentity<Real>(Op);
	}
}

} // namespace Waves

template<typename Real>
void TSpirvThread<Real>::ExecuteTogether(const std::vector<TSpirvThread*>& Together)
{
	const FSpirvStep& Step = Together.front()->GetWaiting();
	const FSpirvInstruction& I = *Step.I;
	if (!IsSpirvWave(I.Op))
	{
		ExecuteQuad(Together);
		return;
	}
	std::vector<TSpirvThread*> ByLane(Together.front()->WaveSize);
	for (TSpirvThread* const Thread : Together)
	{
		ByLane.at(Thread->Lane) = Thread;
	}
	const bool bArithmetic = I.Op >= OpGroupNonUniformIAdd && I.Op <= OpGroupNonUniformBitwiseXor;
	const size_t At = HasGroupOperation(I.Op) ? 2 : 1;
	const auto IsReal = [&](uint32_t Operand, uint32_t Index)
	{
		return Together.front()->IsReal(Together.front()->Program.Module.GetValueTypeId(Operand), Index);
	};
	uint64_t Ballot = 0;
	bool bAllEqual = true;
	for (const TSpirvThread* const Thread : Together)
	{
		const bool bVotes = I.Operands.size() > 1 && Thread->SizeOf(Step, At) && Thread->Bits(Step, At) != 0;
		Ballot |= uint64_t(bVotes) << Thread->Lane;
		for (uint32_t i = 0; I.Op == OpGroupNonUniformAllEqual && i < Thread->SizeOf(Step, 1); ++i)
		{
			const FWord A = Together.front()->Value(Step, 1)[i];
			const FWord B = Thread->Value(Step, 1)[i];
			const bool bDouble = Step.Kind == ESpirvType::Double;
			const bool bSame = bDouble                    ? ToSpirvReal<double>(A) == ToSpirvReal<double>(B)
							   : IsReal(I.Operands[1], i) ? ToSpirvReal<Real>(A) == ToSpirvReal<Real>(B)
														  : A == B;
			bAllEqual = bAllEqual && bSame;
		}
	}
	std::vector<std::vector<FWord>> Results;
	std::vector<FWord> Sum(Step.Size);
	const bool bReduce = bArithmetic && I.Operands[1] == 0;
	for (uint32_t i = 0; bArithmetic && i < Step.Size; ++i)
	{
		Sum[i] = bReduce ? Together.front()->Value(Step, 2)[i] : Waves::GetIdentityOf<Real>(Step.Kind, I.Op);
		for (const TSpirvThread* const Thread : Together)
		{
			const bool bStart = bReduce && Thread == Together.front();
			Sum[i] = bReduce && !bStart ? Waves::CombineOf<Real>(Step.Kind, I.Op, Sum[i], Thread->Value(Step, 2)[i])
										: Sum[i];
		}
	}
	for (TSpirvThread* const Thread : Together)
	{
		std::vector<FWord>& Out = Results.emplace_back(Step.Size);
		const auto Read = [&](uint32_t From)
		{
			const TSpirvThread* const Source = From < ByLane.size() ? ByLane[From] : nullptr;
			for (uint32_t i = 0; Source && i < Step.Size; ++i)
			{
				Out[i] = Source->Value(Step, 1)[i];
			}
		};
		const uint32_t Index = I.Operands.size() > 2 && Thread->SizeOf(Step, 2) ? Thread->Bits(Step, 2) : 0;
		switch (I.Op)
		{
		case OpGroupNonUniformElect:
			Out[0] = Thread == Together.front();
			break;
		case OpGroupNonUniformAll:
			Out[0] = std::all_of(
				Together.begin(), Together.end(), [&](const TSpirvThread* Other) { return Other->Bits(Step, 1) != 0; });
			break;
		case OpGroupNonUniformAny:
			Out[0] = Ballot != 0;
			break;
		case OpGroupNonUniformAllEqual:
			Out[0] = bAllEqual;
			break;
		case OpGroupNonUniformBroadcast:
		case OpGroupNonUniformShuffle:
			Read(Index);
			break;
		case OpGroupNonUniformBroadcastFirst:
			Read(Together.front()->Lane);
			break;
		case OpGroupNonUniformBallot:
			Out[0] = FWord(uint32_t(Ballot));
			Out[1] = FWord(uint32_t(Ballot >> 32));
			break;
		case OpGroupNonUniformBallotBitCount:
		{
			const uint64_t Bits = uint64_t(Thread->Bits(Step, 2, 1)) << 32 | Thread->Bits(Step, 2, 0);
			const uint64_t Before = I.Operands[1] == 0 ? ~uint64_t(0) : (uint64_t(1) << Thread->Lane) - 1;
			Out[0] = FWord(__builtin_popcountll(Bits & Before));
			break;
		}
		case OpGroupNonUniformQuadBroadcast:
			Read((Thread->Lane & ~3u) | (Index & 3));
			break;
		case OpGroupNonUniformQuadSwap:
			Read(Thread->Lane ^ (Index + 1));
			break;
		default:
			Out = Sum;
			for (uint32_t i = 0; !bReduce && i < Step.Size; ++i)
			{
				Sum[i] = Waves::CombineOf<Real>(Step.Kind, I.Op, Sum[i], Thread->Value(Step, 2)[i]);
			}
			break;
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
