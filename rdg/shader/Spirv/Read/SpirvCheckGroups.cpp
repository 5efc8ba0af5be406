// Checks what threads do together: barriers, groupshared memory, atomics.
#include "SpirvChecker.h"

#include "SpirvGroups.h"
#include "SpirvLimits.h"
#include "SpirvRefusals.h"

namespace Drydock
{

using namespace Spirv;

void FSpirvChecker::CheckGroupshared()
{
	uint64_t Bytes = 0;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage != StorageWorkgroup)
		{
			continue;
		}
		const FSpirvType& Type = Module.GetType(Variable.Type);
		if (Module.ExecutionModel != ExecutionModelCompute)
		{
			Module.Fail("groupshared '" + Variable.Name + "': only the threads of a compute shader have groups");
		}
		if (Type.NumScalars == 0)
		{
			Module.Fail("groupshared '" + Variable.Name + "' holds a " + GetHlslTypeName(Module, Type) +
						"; only numbers can be shared");
		}
		for (uint32_t i = 0; i < Type.NumScalars; ++i)
		{
			Bytes += GetSpirvBytes(Module.GetScalarKind(Variable.Type, i));
		}
	}
	if (Bytes > SpirvLimits::MaxGroupsharedBytes)
	{
		Module.Fail("groupshared variables of " + std::to_string(Bytes) + " bytes; Direct3D's limit is " +
					std::to_string(SpirvLimits::MaxGroupsharedBytes) + " a group");
	}
}

/** Pixels and vertices run in any order. */
void FSpirvChecker::CheckOrder()
{
	if (Module.ExecutionModel == ExecutionModelCompute || !FindGroupUse(Module).bWaves)
	{
		return;
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (IsSpirvAtomic(I.Op))
			{
				Module.Fail("an atomic operation of which the order is seen: pixels have none. Do not use its result, "
							"nor read what it changes in the same pass, or do it in a compute shader",
					&I);
			}
		}
	}
}

void FSpirvChecker::CheckWave(const FSpirvInstruction& I)
{
	ExpectCount(I, 1);
	switch (I.Op)
	{
	case OpGroupNonUniformElect:
		Expect(ResultSize(I) == 1, I);
		return;
	case OpGroupNonUniformAll:
	case OpGroupNonUniformAny:
		Expect(ResultSize(I) == 1 && Size(I, 1) == 1 && Module.GetValueType(I.Operands[1]).Kind == ESpirvType::Bool, I);
		return;
	case OpGroupNonUniformAllEqual:
		Expect(ResultSize(I) == 1 && Size(I, 1) != 0, I);
		return;
	case OpGroupNonUniformBallot:
		Expect(ResultSize(I) == 4 && Size(I, 1) == 1 && Module.GetValueType(I.Operands[1]).Kind == ESpirvType::Bool, I);
		return;
	case OpGroupNonUniformBallotBitCount:
		ExpectCount(I, 3);
		Expect(ResultSize(I) == 1 && Size(I, 2) == 4 && (I.Operands[1] == 0 || I.Operands[1] == 2), I);
		return;
	case OpGroupNonUniformBroadcastFirst:
		Expect(Size(I, 1) == ResultSize(I), I);
		return;
	case OpGroupNonUniformBroadcast:
	case OpGroupNonUniformShuffle:
	case OpGroupNonUniformQuadBroadcast:
	case OpGroupNonUniformQuadSwap:
		Expect(Size(I, 1) == ResultSize(I) && Size(I, 2) == 1, I);
		return;
	default:
	{
		const bool bArithmetic = I.Op >= OpGroupNonUniformIAdd && I.Op <= OpGroupNonUniformBitwiseXor;
		if (!bArithmetic)
		{
			Module.Fail(GetSpirvOpName(I.Op) + ": this wave operation is not one of HLSL's", &I);
		}
		ExpectCount(I, 3);
		Expect(Size(I, 2) == ResultSize(I) && (I.Operands[1] == 0 || I.Operands[1] == 2), I);
		return;
	}
	}
}

/** Checks what the pixels of a quad do together. */
void FSpirvChecker::CheckQuad(const FSpirvInstruction& I)
{
	if (IsSpirvWave(I.Op))
	{
		CheckWave(I);
		Expect(I.Op != OpGroupNonUniformQuadSwap || Module.FindConstant(I.Operands[2]), I);
	}
	else if (I.Op == OpImageQueryLod)
	{
		const FSpirvType& Type = Image(I, 0);
		const uint32_t Needed = Type.Dim == Dim2D ? 2 : 3;
		Expect(Type.Dim != DimBuffer && Size(I, 1) >= Needed && ResultSize(I) == 2, I);
		Expect(Module.GetValueType(I.Operands[0]).Kind == ESpirvType::SampledImage, I);
	}
	else if (I.Op != OpDemote)
	{
		const bool bReal = I.Type && ResultSize(I) != 0 && Module.GetScalarKind(I.Type, 0) == ESpirvType::Float;
		Expect(bReal && Size(I, 0) == ResultSize(I), I);
	}
}

bool FSpirvChecker::CheckGroups(const FSpirvInstruction& I)
{
	if (I.Op == OpControlBarrier || I.Op == OpMemoryBarrier)
	{
		if (I.Op == OpControlBarrier && Module.ExecutionModel != ExecutionModelCompute)
		{
			Module.Fail("GroupMemoryBarrierWithGroupSync: only the threads of a compute shader have groups", &I);
		}
		return true;
	}
	if (I.Op == OpImageTexelPointer)
	{
		ExpectCount(I, 3);
		const FSpirvVariable* const Variable = Module.FindVariable(I.Operands[0]);
		Expect(Variable && Module.GetType(Variable->Type).Kind == ESpirvType::Image, I);
		const FSpirvType& Type = Module.GetType(Variable->Type);
		const bool bFits = Type.bStorageImage && !Type.bMultisampled &&
						   (Type.Dim == Dim2D || Type.Dim == Dim3D || Type.Dim == DimBuffer);
		if (!bFits)
		{
			Module.Fail("Interlocked* works on RWTexture2D, RWTexture2DArray, RWTexture3D and RWBuffer", &I);
		}
		const uint32_t Needed = Type.Dim == DimBuffer ? 1 : Type.Dim == Dim3D || Type.bArrayed ? 3 : 2;
		Expect(Size(I, 1) >= Needed, I);
		return true;
	}
	if (IsSpirvWave(I.Op))
	{
		CheckWave(I);
		return true;
	}
	if (!IsSpirvAtomic(I.Op))
	{
		return false;
	}
	const bool bNoValue = I.Op == OpAtomicLoad || I.Op == OpAtomicIIncrement || I.Op == OpAtomicIDecrement;
	const size_t NumOperands = I.Op == OpAtomicCompareExchange ? 6 : bNoValue ? 3 : 4;
	Expect(I.Operands.size() == NumOperands && I.Op != OpAtomicCompareExchange + 1, I);
	const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
	Expect(Pointer.Kind == ESpirvType::Pointer, I);
	const ESpirvType Kind = Module.GetType(Pointer.Element).Kind;
	const uint32_t Storage = Pointer.Storage;
	const bool bWide = Kind == ESpirvType::Long || Kind == ESpirvType::Ulong;
	if (bWide && Storage == StorageImage)
	{
		Module.Fail("Interlocked* works on textures and typed buffers of int and uint; one of 64 bits on groupshared "
					"variables and structured buffers",
			&I);
	}
	if (Kind != ESpirvType::Int && Kind != ESpirvType::Uint && !bWide)
	{
		Module.Fail("Interlocked* works on int, uint, int64_t and uint64_t", &I);
	}
	if (Storage != StorageWorkgroup && Storage != StorageUniform && Storage != StorageStorageBuffer &&
		Storage != StorageImage)
	{
		Module.Fail("Interlocked* works on groupshared variables and on what is bound for writing", &I);
	}
	Expect(!I.Result || Module.GetType(I.Type).Kind == Kind, I);
	for (size_t i = NumOperands == 6 ? 4 : 3; i < NumOperands; ++i)
	{
		Expect(Size(I, i) == 1, I);
	}
	return true;
}

} // namespace Drydock
