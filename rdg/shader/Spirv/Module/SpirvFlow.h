// Finds which scalars of a result come from which scalars of the operands, for every analysis that follows values
// through a shader.
#pragma once

#include "SpirvModule.h"

#include <algorithm>

namespace Drydock
{

/** In place of a scalar's index: all of the value. */
constexpr uint32_t GAnyScalar = ~0u;

/** Each scalar of the result comes from the same scalars of the operands. */
bool IsComponentwise(const FSpirvModule& Module, const FSpirvInstruction& I);

/** The result is computed from the operands alone. */
bool HasFlow(const FSpirvInstruction& I);

/** Calls Copy(To, Value, From) for scalars From of operands that go into scalar To of the result. False where
 *  HasFlow is false. */
template<typename TCopy>
bool ForEachFlow(const FSpirvModule& Module, const FSpirvInstruction& I, TCopy Copy)
{
	using namespace Spirv;
	const auto SizeOf = [&Module](uint32_t Value)
	{
		return std::max(1u, Module.GetValueType(Value).NumScalars);
	};
	if (!HasFlow(I))
	{
		return false;
	}
	const uint32_t Size = SizeOf(I.Result);
	switch (I.Op)
	{
	case OpVectorShuffle:
	{
		const uint32_t First = SizeOf(I.Operands[0]);
		for (uint32_t i = 0; i < Size; ++i)
		{
			const uint32_t From = I.Operands[2 + i];
			if (From != ~0u)
			{
				From < First ? Copy(i, I.Operands[0], From) : Copy(i, I.Operands[1], From - First);
			}
		}
		break;
	}
	case OpCompositeConstruct:
	{
		uint32_t To = 0;
		for (const uint32_t Part : I.Operands)
		{
			const uint32_t PartSize = SizeOf(Part);
			for (uint32_t i = 0; i < PartSize; ++i)
			{
				Copy(To++, Part, i);
			}
		}
		break;
	}
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const bool bInsert = I.Op == OpCompositeInsert;
		const size_t Composite = bInsert ? 1 : 0;
		const FSpirvModule::FPart Part = Module.FindPart(Module.GetValueTypeId(I.Operands[Composite]),
			I.Operands.data() + Composite + 1, I.Operands.data() + I.Operands.size());
		const uint32_t PartSize = Module.GetType(Part.Type).NumScalars;
		for (uint32_t i = 0; i < Size; ++i)
		{
			const bool bInPart = i >= Part.Offset && i < Part.Offset + PartSize;
			!bInsert  ? Copy(i, I.Operands[0], Part.Offset + i)
			: bInPart ? Copy(i, I.Operands[0], i - Part.Offset)
					  : Copy(i, I.Operands[1], i);
		}
		break;
	}
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		for (uint32_t i = 0; i < Size; ++i)
		{
			Copy(i, I.Operands[0], i);
			Copy(i, I.Operands[1], 0);
		}
		break;
	default:
	{
		const bool bComponentwise = IsComponentwise(Module, I);
		for (size_t k = I.Op == OpExtInst ? 2 : 0; k < I.Operands.size(); ++k)
		{
			for (uint32_t i = 0; i < Size; ++i)
			{
				Copy(i, I.Operands[k], bComponentwise ? i : GAnyScalar);
			}
		}
		break;
	}
	}
	return true;
}

/** Numbers of -1..1 or 0..1 in the bits of one uint, the first one lowest. */
struct FSpirvNorms
{
	uint32_t Ext = 0;
	uint32_t Count = 0; // of numbers
	bool bSigned = false;
	bool bPacks = false;

	uint32_t GetBits() const { return 32 / Count; }
	/** The code of 1. */
	uint32_t GetOne() const { return (1u << (GetBits() - (bSigned ? 1 : 0))) - 1; }
};

/** Null: Ext is none of these functions. */
const FSpirvNorms* FindSpirvNorms(uint32_t Ext);

} // namespace Drydock
