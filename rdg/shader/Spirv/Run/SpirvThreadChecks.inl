// Accesses that go wrong, told to the observer: outside of textures, buffers and arrays, and of what nothing wrote.
#pragma once

#include "SpirvThread.h"

namespace Drydock
{

using namespace Spirv;

template<typename Real>
void TSpirvThread<Real>::Fault(const FSpirvStep& Step, const FSpirvFault& Found)
{
	if (Observer)
	{
		Observer->OnFault(*this, Step, Found);
	}
}

template<typename Real>
void TSpirvThread<Real>::CheckTexel(
	const FSpirvStep& Step, const FKernelTexture& Texture, const int32_t (&At)[4], bool bStore)
{
	FSpirvFault Found{ESpirvFault::Texel, Resource(Step, 0).Name, {At[0], At[1], At[2], At[3]}, {}, bStore, false};
	const bool bMip = At[3] >= 0 && At[3] < Texture.NumMips;
	if (bMip)
	{
		const FKernelMip& Mip = Texture.Mips[At[3]];
		Found.Bounds[0] = Mip.SizeX;
		Found.Bounds[1] = Mip.SizeY;
		Found.Bounds[2] = Mip.SizeZ;
	}
	if (!bMip || At[0] < 0 || At[1] < 0 || At[2] < 0 || At[0] >= Found.Bounds[0] || At[1] >= Found.Bounds[1] ||
		At[2] >= Found.Bounds[2])
	{
		Fault(Step, Found);
	}
}

template<typename Real>
void TSpirvThread<Real>::CheckElement(const FSpirvStep& Step, const FKernelBuffer& Buffer, uint64_t Index, bool bStore)
{
	const uint32_t Count = Lanes::BufferElements(Buffer);
	if (Index < Count)
	{
		return;
	}
	const bool bTyped = Step.Place == ~0u;
	const FSpirvVariable& Variable =
		bTyped ? Resource(Step, 0) : Program.Module.Variables.at(uint32_t(Value(Step, 0)[2]));
	Fault(Step, {ESpirvFault::Element, Variable.Name, {int64_t(Index)}, {Count}, bStore, false});
}

template<typename Real>
void TSpirvThread<Real>::ReportUndefined(const FSpirvStep& Step, uint32_t Word, bool bAtEnd)
{
	const uint32_t Origin = Undefined[Word] - 1;
	Undefined[Word] = 0; // once
	FSpirvFault Found{ESpirvFault::Undefined, {}, {}, {}, false, bAtEnd};
	for (size_t i = 0; i < Program.Memory.size(); ++i)
	{
		const FSpirvMemory& Memory = Program.Memory[i];
		if (Origin >= Memory.First && Origin < Memory.First + Memory.Size)
		{
			Found.What = Program.VariableNames[i];
			Found.At[0] = Origin - Memory.First;
			Found.Bounds[0] = Memory.Size;
		}
	}
	Fault(Step, Found);
}

template<typename Real>
void TSpirvThread<Real>::CheckDefined(const FSpirvStep& Step, size_t Operand)
{
	const uint32_t First = Arg(Step, Operand);
	if (First == GNoSpirvWord)
	{
		return;
	}
	const uint32_t Size = SizeOf(Step, Operand);
	for (uint32_t i = 0; i < Size; ++i)
	{
		if (Undefined[First + i])
		{
			ReportUndefined(Step, First + i, false);
		}
	}
}

template<typename Real>
void TSpirvThread<Real>::CheckSampleDefined(const FSpirvStep& Step)
{
	const FSpirvImageOperands Told = GetImageOperands(*Step.I);
	for (const size_t Operand : {size_t(1), Told.Reference, Told.Bias, Told.Lod, Told.GradX, Told.GradY, Told.Offset,
			 Told.Offsets, Told.MinLod})
	{
		if (Operand)
		{
			CheckDefined(Step, Operand);
		}
	}
}

/** Values are moved about with the mark that nothing wrote them; what computes with them, or leaves the thread with
 * them, is at fault. */
template<typename Real>
void TSpirvThread<Real>::FollowUndefined(const FSpirvStep& Step)
{
	const FSpirvInstruction& I = *Step.I;
	size_t First = 0;
	size_t Last = I.Operands.size();
	switch (I.Op)
	{
	case OpLoad:
	case OpAccessChain:
	case OpInBoundsAccessChain:
	case OpVectorShuffle:
	case OpCompositeConstruct:
	case OpCompositeExtract:
	case OpCompositeInsert:
	case OpTranspose:
	case OpCopyObject:
	case OpSampledImage:
	case OpImage:
	case OpFunctionCall:
	case OpArrayLength:
		return;
	case OpStore:
		if (Step.Place != ~0u)
		{
			CheckDefined(Step, 1);
		}
		return;
	case OpSelect:
		CheckDefined(Step, 0);
		return;
	case OpVectorExtractDynamic:
		CheckDefined(Step, 1);
		return;
	case OpVectorInsertDynamic:
		CheckDefined(Step, 2);
		return;
	case OpExtInst:
		First = 2;
		break;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageFetch:
	case OpImageRead:
	case OpImageGather:
	case OpImageDrefGather:
		CheckSampleDefined(Step);
		Last = 0;
		break;
	case OpImageQuerySizeLod:
		First = 1;
		break;
	case OpImageWrite:
		First = 1;
		Last = std::min<size_t>(Last, 3);
		break;
	default:
		// Behind the scope, arithmetic has a literal for its extent.
		First = IsSpirvWave(I.Op) ? (I.Operands.size() > 2 && HasGroupOperation(I.Op) ? 2 : 1) : 0;
		break;
	}
	for (size_t k = First; k < Last; ++k)
	{
		const bool bPointer = Program.Module.GetValueType(I.Operands[k]).Kind == ESpirvType::Pointer;
		if (!bPointer)
		{
			CheckDefined(Step, k);
		}
	}
	std::fill_n(Undefined.begin() + (Step.Size ? Step.To : 0), Step.Size, 0u);
}

template<typename Real>
void TSpirvThread<Real>::CheckOutputs()
{
	for (size_t i = 0; i < Program.Memory.size(); ++i)
	{
		for (uint32_t k = 0; Program.Module.Variables[i].Storage == StorageOutput && k < Program.Memory[i].Size; ++k)
		{
			if (Undefined[Program.Memory[i].First + k])
			{
				ReportUndefined(Program.Steps.back(), Program.Memory[i].First + k, true);
			}
		}
	}
}

} // namespace Drydock
