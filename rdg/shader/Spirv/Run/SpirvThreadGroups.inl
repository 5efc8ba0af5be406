// Runs what threads of a group do together: waiting for each other, atomics.
#pragma once

#include "SpirvThread.h"

namespace Drydock
{

using namespace Spirv;

template<typename Real>
void TSpirvThread<Real>::SetOrder(const FSpirvOrder* InOrder)
{
	Order = InOrder;
	Turns.assign(Order ? Program.Blocks.size() : 0, 0);
}

template<typename Real>
std::vector<uint32_t> TSpirvThread<Real>::GetWhereInOrder() const
{
	std::vector<uint32_t> Where;
	const auto Add = [this, &Where](uint32_t InBlock, uint32_t Step)
	{
		for (const uint32_t Header : Order->Loops[InBlock])
		{
			Where.push_back(Order->Places[Header]);
			Where.push_back(Turns[Header]);
		}
		Where.push_back(Order->Places[InBlock]);
		Where.push_back(0); // as long as an entry of a loop
		Where.push_back(Step);
	};
	for (const FCall& Call : Calls)
	{
		Add(Call.Block, Call.Step);
	}
	Add(Block, At);
	return Where;
}

template<typename Real>
void TSpirvThread<Real>::SetLog(std::vector<FWord>* InLog, bool bInReplay)
{
	Log = InLog;
	bReplay = bInReplay;
	LogPosition = 0;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteWaiting()
{
	const FSpirvStep& Step = GetWaiting();
	const bool bTogether = ChoosesSpirvLevel(Step.I->Op) || IsSpirvDerivative(Step.I->Op);
	if ((bTogether || IsSpirvWave(Step.I->Op)) && !(Log && bReplay))
	{
		ExecuteTogether({this});
		return;
	}
	if (Step.I->Op != OpControlBarrier)
	{
		Execute(Step);
	}
	ShowWaiting();
}

template<typename Real>
void TSpirvThread<Real>::ShowWaiting()
{
	if (GetWaiting().bHook && Observer)
	{
		Observer->OnStep(*this, GetWaiting());
	}
}

template<typename Real>
void TSpirvThread<Real>::Note(const FSpirvStep& Step)
{
	if (Step.bOfOthers && Log && !bReplay)
	{
		Log->insert(Log->end(), Result(Step), Result(Step) + Step.Size);
	}
}

template<typename Real>
void TSpirvThread<Real>::TellRaces(
	const FSpirvStep& Step, uint32_t Word, uint32_t Size, ESharedAccess Access, const FWord* Values)
{
	for (uint32_t i = 0; Races && IsShared(Word) && i < Size; ++i)
	{
		Races->Touch(GroupIndex, Word - Program.Groupshared.First + i, Step, Access, uint64_t(Values[i]));
	}
}

template<typename Real>
void TSpirvThread<Real>::StepOver()
{
	++At;
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteFromLog(const FSpirvStep& Step)
{
	// For what an observer is told of where it reads.
	if (Observer && Step.I->Op == OpLoad && Step.Place != ~0u)
	{
		LoadBytes(Step);
	}
	else if (Observer && Step.I->Op == OpImageRead)
	{
		ExecuteImageLoad(Step);
	}
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		Result(Step)[i] = TakeFromLog(Step);
	}
	return true;
}

template<typename Real>
typename TSpirvThread<Real>::FWord TSpirvThread<Real>::TakeFromLog(const FSpirvStep& Step)
{
	if (LogPosition >= Log->size())
	{
		Program.Module.Fail("the thread takes another way than in its group", Step.I);
	}
	return (*Log)[LogPosition++];
}

template<typename Real>
template<typename FBits>
FBits TSpirvThread<Real>::ReplaceAtomically(FBits* Place, const FSpirvStep& Step)
{
	using FSigned = std::make_signed_t<FBits>;
	const auto Operand = [this, &Step](size_t Index)
	{
		return FBits(Value(Step, Index)[0]);
	};
	const auto Replace = [Place](auto New)
	{
		FBits Old = __atomic_load_n(Place, __ATOMIC_RELAXED);
		while (!__atomic_compare_exchange_n(Place, &Old, FBits(New(Old)), true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
		{
		}
		return Old;
	};
	switch (Step.I->Op)
	{
	case OpAtomicLoad:
		return Replace([](FBits Old) { return Old; });
	case OpAtomicStore:
	case OpAtomicExchange:
		return Replace([&](FBits) { return Operand(3); });
	case OpAtomicCompareExchange:
		return Replace([&](FBits Old) { return Old == Operand(5) ? Operand(4) : Old; });
	case OpAtomicIIncrement:
		return Replace([](FBits Old) { return Old + 1; });
	case OpAtomicIDecrement:
		return Replace([](FBits Old) { return Old - 1; });
	case OpAtomicIAdd:
		return Replace([&](FBits Old) { return Old + Operand(3); });
	case OpAtomicISub:
		return Replace([&](FBits Old) { return Old - Operand(3); });
	case OpAtomicSMin:
		return Replace([&](FBits Old) { return std::min(FSigned(Old), FSigned(Operand(3))); });
	case OpAtomicUMin:
		return Replace([&](FBits Old) { return std::min(Old, Operand(3)); });
	case OpAtomicSMax:
		return Replace([&](FBits Old) { return std::max(FSigned(Old), FSigned(Operand(3))); });
	case OpAtomicUMax:
		return Replace([&](FBits Old) { return std::max(Old, Operand(3)); });
	case OpAtomicAnd:
		return Replace([&](FBits Old) { return Old & Operand(3); });
	case OpAtomicOr:
		return Replace([&](FBits Old) { return Old | Operand(3); });
	default:
		return Replace([&](FBits Old) { return Old ^ Operand(3); });
	}
}

/** Word 0 of a pointer to a texel counts texels, row by row and layer by layer; outside it is Nowhere. */
template<typename Real>
void TSpirvThread<Real>::PointAtTexel(const FSpirvStep& Step)
{
	const uint32_t Variable = Bits(Step, 0, 2);
	const FSpirvType& Type = Program.Module.GetType(Program.Module.Variables.at(Variable).Type);
	FWord* const Out = Result(Step);
	uint64_t Index = Bits(Step, 1);
	bool bInside = false;
	if (Type.Dim == DimBuffer)
	{
		const FKernelBuffer& Buffer = ViewOf(Args->RWBuffers, Variable);
		bInside = Buffer.Storage == ETexelStorage::R32_UINT && Index < Buffer.SizeInBytes / 4;
	}
	else
	{
		const FKernelTexture& Texture = ViewOf(Args->RWTextures, Variable);
		const FKernelMip& Mip = Texture.Mips[0];
		const uint32_t Y = Bits(Step, 1, 1);
		const uint32_t Z = SizeOf(Step, 1) > 2 && (Type.Dim == Dim3D || Type.bArrayed) ? Bits(Step, 1, 2) : 0;
		bInside = Texture.Storage == ETexelStorage::R32_UINT && Index < uint32_t(Mip.SizeX) &&
				  Y < uint32_t(Mip.SizeY) && Z < uint32_t(Mip.SizeZ);
		Index += (uint64_t(Z) * uint64_t(Mip.SizeY) + Y) * uint64_t(Mip.SizeX);
	}
	Out[0] = bInside ? FWord(Index) : FWord(Nowhere);
	Out[1] = 0;
	Out[2] = FWord(Variable);
}

template<typename Real>
uint32_t* TSpirvThread<Real>::FindTexel(const FSpirvStep& Step)
{
	const uint32_t Index = Bits(Step, 0);
	const uint32_t Variable = Bits(Step, 0, 2);
	if (Index == Nowhere)
	{
		return nullptr;
	}
	if (Program.Module.GetType(Program.Module.Variables.at(Variable).Type).Dim == DimBuffer)
	{
		return reinterpret_cast<uint32_t*>(ViewOf(Args->RWBuffers, Variable).Data) + Index;
	}
	const FKernelMip& Mip = ViewOf(Args->RWTextures, Variable).Mips[0];
	const uint32_t Row = Index / uint32_t(Mip.SizeX);
	const uint32_t Z = Row / uint32_t(Mip.SizeY);
	uint8_t* const Line = Mip.Data + Z * Mip.SlicePitch + int64_t(Row % uint32_t(Mip.SizeY)) * Mip.RowPitch;
	return reinterpret_cast<uint32_t*>(Line) + Index % uint32_t(Mip.SizeX);
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteAtomic(const FSpirvStep& Step)
{
	const FSpirvInstruction& I = *Step.I;
	if (I.Op == OpMemoryBarrier || I.Op == OpControlBarrier)
	{
		return true;
	}
	if (I.Op == OpImageTexelPointer)
	{
		PointAtTexel(Step);
		return true;
	}
	if (!IsSpirvAtomic(I.Op))
	{
		return false;
	}
	const FSpirvType& Pointer = Program.Module.GetValueType(I.Operands[0]);
	const uint32_t Size = GetSpirvBytes(Program.Module.GetType(Pointer.Element).Kind);
	void* Place = nullptr;
	FWord* Word = nullptr;
	if (Pointer.Storage == StorageImage)
	{
		Place = FindTexel(Step);
	}
	else if (Pointer.Storage == StorageWorkgroup)
	{
		Word = MemoryAt(Step, Bits(Step, 0), 1);
		TellRaces(Step, Bits(Step, 0), 1, ESharedAccess::Atomic, Word);
	}
	else
	{
		const uint32_t Variable = Bits(Step, 0, 2);
		const FKernelBuffer* const Buffer = FindBuffer(Variable);
		const uint32_t Stride = Step.Place == ~0u ? 0 : Program.PlaceOf(Step).ElementStride;
		if (!Buffer || !Stride)
		{
			Program.Module.Fail(
				"an atomic operation on '" + Program.Module.Variables.at(Variable).Name + "', which is read-only", &I);
		}
		const uint32_t Element = Bits(Step, 0, 1);
		const uint64_t Byte = uint64_t(Element) * Stride + Bits(Step, 0);
		const bool bInside = Element < Buffer->SizeInBytes / Stride && Byte + Size <= Buffer->SizeInBytes;
		Place = bInside ? Buffer->Data + Byte : nullptr;
		if (Observer)
		{
			CheckElement(Step, *Buffer, Element, true);
		}
	}
	const auto Replace = [&](auto Number)
	{
		using FBits = decltype(Number);
		FBits* const At = Word ? &Number : static_cast<FBits*>(Place);
		const FBits Before = At && Stores() ? ReplaceAtomically(At, Step) : FBits(0);
		if (Word)
		{
			*Word = FWord(Number);
		}
		return FWord(Before);
	};
	const FWord Shared = Word ? *Word : FWord(0);
	const FWord Old = Size == 8 ? Replace(uint64_t(Shared)) : Replace(uint32_t(Shared));
	if (I.Result)
	{
		Result(Step)[0] = Old;
	}
	return true;
}

} // namespace Drydock
