// Pointers, variables and buffers of a thread.
#pragma once

#include "SpirvThread.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

template<typename Real>
void TSpirvThread<Real>::ExecuteChain(const FSpirvStep& Step)
{
	const FSpirvPlace& Place = Program.PlaceOf(Step);
	const FWord* const Base = Value(Step, 0);
	uint64_t Offset = uint64_t(Base[0]) + Place.Offset;
	for (const FSpirvIndex& Index : Place.Indices)
	{
		const uint32_t At = uint32_t(Words[Program.WordOf(Index.Value)]);
		if (At >= Index.Count && Observer)
		{
			FSpirvFault Found{ESpirvFault::Index, {}, {int32_t(At)}, {Index.Count}, false, false};
			Fault(Step, Found);
		}
		Offset += uint64_t(std::min(At, Index.Count - 1)) * Index.Stride;
	}
	FWord* const Out = Result(Step);
	const FWord Variable = Base[2];
	const FWord Element = Place.ElementStride ? FWord(uint32_t(Words[Program.WordOf(Place.Element)])) : Base[1];
	Out[0] = FWord(Offset);
	Out[1] = Element;
	Out[2] = Variable;
}

template<typename Real>
auto TSpirvThread<Real>::MemoryAt(const FSpirvStep& Step, uint32_t Word, uint32_t Size) -> FWord*
{
	const bool bShared = IsShared(Word);
	const size_t End = bShared ? size_t(Program.Groupshared.First) + Program.Groupshared.Size : Words.size();
	if (size_t(Word) + Size > End)
	{
		Program.Module.Fail("SPIR-V: a pointer to nowhere", Step.I);
	}
	return bShared ? Groupshared + (Word - Program.Groupshared.First) : Words.data() + Word;
}

template<typename Real>
void TSpirvThread<Real>::Load(const FSpirvStep& Step)
{
	if (Step.Place != ~0u)
	{
		LoadBytes(Step);
		return;
	}
	const uint32_t From = uint32_t(Value(Step, 0)[0]);
	std::copy_n(MemoryAt(Step, From, Step.Size), Step.Size, Result(Step));
	TellRaces(Step, From, Step.Size, ESharedAccess::Read, Result(Step));
	if (!Undefined.empty() && IsShared(From))
	{
		std::fill_n(Undefined.begin() + Step.To, Step.Size, 0u);
	}
	else if (!Undefined.empty())
	{
		std::copy_n(Undefined.begin() + From, Step.Size, Undefined.begin() + Step.To);
	}
}

template<typename Real>
void TSpirvThread<Real>::Store(const FSpirvStep& Step, uint32_t Pointer, const FWord* From, uint32_t Size)
{
	std::copy_n(From, Size, MemoryAt(Step, Pointer, Size));
	TellRaces(Step, Pointer, Size, ESharedAccess::Write, From);
	if (!Undefined.empty() && !IsShared(Pointer))
	{
		std::copy_n(Undefined.begin() + (From - Words.data()), Size, Undefined.begin() + Pointer);
	}
}

template<typename Real>
const FKernelBuffer* TSpirvThread<Real>::FindBuffer(uint32_t Variable) const
{
	const FSpirvType& Type = Program.Module.GetType(Program.Module.Variables.at(Variable).Type);
	if (!Type.bBufferBlock)
	{
		return nullptr;
	}
	return &ViewOf(Type.Members.at(0).bNonWritable ? Args->Buffers : Args->RWBuffers, Variable);
}

template<typename Real>
void TSpirvThread<Real>::LoadBytes(const FSpirvStep& Step)
{
	const FSpirvPlace& Place = Program.PlaceOf(Step);
	const FWord* const Pointer = Value(Step, 0);
	const uint32_t Offset = uint32_t(Pointer[0]);
	const uint32_t Element = uint32_t(Pointer[1]);
	const uint32_t Variable = uint32_t(Pointer[2]);
	const FKernelBuffer* const Buffer = FindBuffer(Variable);
	FWord* const Out = Result(Step);
	for (uint32_t i = 0; i < Place.Scalars.size() && i < Step.Size; ++i)
	{
		uint64_t Loaded = 0;
		const ESpirvType Kind = GetKind(Step.I->Type, i);
		const uint32_t Size = GetSpirvBytes(Kind);
		const uint32_t At = Offset + Place.Scalars[i];
		if (!Buffer)
		{
			const uint8_t* const Data = ViewOf(Args->ConstantBuffers, Variable);
			if (Data)
			{
				std::memcpy(&Loaded, Data + At, Size);
			}
		}
		else
		{
			const uint64_t Byte = uint64_t(Element) * Place.ElementStride + At;
			if (Element < Buffer->SizeInBytes / std::max(1u, Place.ElementStride) && Byte + Size <= Buffer->SizeInBytes)
			{
				std::memcpy(&Loaded, Buffer->Data + Byte, Size);
			}
		}
		Out[i] = FromSpirvMemory<Real>(Kind, Loaded);
	}
	if (Buffer && Observer)
	{
		CheckElement(Step, *Buffer, Element, false);
	}
}

template<typename Real>
void TSpirvThread<Real>::StoreBytes(const FSpirvStep& Step)
{
	const FSpirvPlace& Place = Program.PlaceOf(Step);
	const FWord* const Pointer = Value(Step, 0);
	const uint32_t Element = uint32_t(Pointer[1]);
	const uint32_t Variable = uint32_t(Pointer[2]);
	const FKernelBuffer* const Buffer = FindBuffer(Variable);
	if (!Buffer || !Place.ElementStride)
	{
		Program.Module.Fail("a store into '" + Program.Module.Variables.at(Variable).Name + "', which is read-only");
	}
	const uint32_t Type = Program.Module.GetValueTypeId(Step.I->Operands[1]);
	const FWord* const From = Value(Step, 1);
	for (uint32_t i = 0; i < Place.Scalars.size() && i < SizeOf(Step, 1); ++i)
	{
		const ESpirvType Kind = GetKind(Type, i);
		const uint32_t Size = GetSpirvBytes(Kind);
		const uint64_t Stored = ToSpirvMemory<Real>(Kind, From[i]);
		const uint64_t Byte = uint64_t(Element) * Place.ElementStride + uint32_t(Pointer[0]) + Place.Scalars[i];
		if (Stores() && Element < Buffer->SizeInBytes / Place.ElementStride && Byte + Size <= Buffer->SizeInBytes)
		{
			std::memcpy(Buffer->Data + Byte, &Stored, Size);
		}
	}
	if (Observer)
	{
		CheckElement(Step, *Buffer, Element, true);
	}
}

template<typename Real>
void TSpirvThread<Real>::ArrayLength(const FSpirvStep& Step)
{
	const uint32_t Variable = uint32_t(Value(Step, 0)[2]);
	const FSpirvVariable& Found = Program.Module.Variables.at(Variable);
	const FKernelBuffer* const Buffer = FindBuffer(Variable);
	const uint32_t Stride =
		Program.Module.GetType(Program.Module.GetMemberType(Found.Type, Step.I->Operands[1])).ArrayStride;
	Result(Step)[0] = Buffer ? Buffer->SizeInBytes / std::max(1u, Stride) : 0;
}

} // namespace Drydock
