// Finds what threads do together. Source of the rules for what commutes: every operation but exchanges and stores gives
// one result in any order, as long as it is the only one on its memory.
#include "SpirvGroups.h"

#include <algorithm>
#include <set>

namespace Drydock
{

using namespace Spirv;

namespace
{

bool IsChain(uint16_t Op)
{
	return Op == OpAccessChain || Op == OpInBoundsAccessChain || Op == OpImageTexelPointer;
}

/** Signed and unsigned, increments and sums: the same thing to whoever reads the result. */
uint16_t GetKind(uint16_t Op)
{
	switch (Op)
	{
	case OpAtomicIIncrement:
	case OpAtomicIDecrement:
	case OpAtomicISub:
		return OpAtomicIAdd;
	default:
		return Op;
	}
}

bool Commutes(uint16_t Op)
{
	return Op >= OpAtomicIIncrement;
}

/** Other uses of the memory that a buffer's or texture's atomics change. */
struct FSharedMemory
{
	std::set<uint16_t> Kinds;
	std::set<uint32_t> Widths; // in bytes: a carry goes from one half of 64 bits to the other
	bool bOrderSeen = false;
};

/** The variable that stands for a buffer's memory: the first of several views of it. */
uint32_t GetMemoryId(const FSpirvModule& Module, uint32_t Id)
{
	const FSpirvVariable* const Variable = Module.FindVariable(Id);
	if (!Variable || !Module.GetType(Variable->Type).bBufferBlock || Variable->Name.empty())
	{
		return Id;
	}
	return std::find_if(Module.Variables.begin(), Module.Variables.end(),
		[&](const FSpirvVariable& Other)
		{ return Other.Name == Variable->Name && Module.GetType(Other.Type).bBufferBlock; })
		->Id;
}

} // namespace

const FSpirvVariable* FindAtomicVariable(const FSpirvModule& Module, const FSpirvInstruction& Atomic,
	const std::unordered_map<uint32_t, const FSpirvInstruction*>& Pointers)
{
	const auto Found = Pointers.find(Atomic.Operands[0]);
	return Module.FindVariable(Found == Pointers.end() ? Atomic.Operands[0] : Found->second->Operands[0]);
}

FSpirvGroupUse FindGroupUse(const FSpirvModule& Module)
{
	FSpirvGroupUse Use;
	std::unordered_map<uint32_t, const FSpirvInstruction*> Pointers;
	std::set<uint32_t> Used; // values; a literal that looks like an id is a use too many
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (IsChain(I.Op) || I.Op == OpLoad)
			{
				Pointers[I.Result] = &I;
			}
			// Scope and semantics of an atomic are constants, never its neighbours' results.
			Used.insert(I.Operands.begin(), I.Operands.end());
			Use.bGroups = Use.bGroups || I.Op == OpControlBarrier;
			Use.bWaves = Use.bWaves || (IsSpirvWave(I.Op) && Module.ExecutionModel != ExecutionModelFragment);
		}
	}
	std::map<uint32_t, FSharedMemory> Memory; // by variable
	std::map<uint32_t, FSharedMemory> Groupshared;
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (!IsSpirvAtomic(I.Op))
			{
				continue;
			}
			const bool bSeen = Used.count(I.Result) || !Commutes(I.Op);
			Use.bWaves = Use.bWaves || bSeen;
			if (const FSpirvVariable* const Variable = FindAtomicVariable(Module, I, Pointers))
			{
				const bool bGroupshared = Variable->Storage == StorageWorkgroup;
				FSharedMemory& Shared = (bGroupshared ? Groupshared : Memory)[GetMemoryId(Module, Variable->Id)];
				Shared.Kinds.insert(GetKind(I.Op));
				Shared.Widths.insert(GetSpirvBytes(Module.GetType(Module.GetValueType(I.Operands[0]).Element).Kind));
				Shared.bOrderSeen = Shared.bOrderSeen || bSeen;
				Use.bWaves = Use.bWaves || (bGroupshared && Shared.Kinds.size() > 1);
			}
		}
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			const bool bReads = I.Op == OpLoad || I.Op == OpImageRead;
			const bool bPlain = bReads || I.Op == OpStore || I.Op == OpImageWrite;
			if (!bPlain || I.Operands.empty())
			{
				continue;
			}
			const auto Pointer = Pointers.find(I.Operands[0]);
			const bool bHandle = I.Op == OpLoad && Module.GetType(I.Type).NumScalars == 0;
			const auto Known = Memory.find(
				GetMemoryId(Module, Pointer == Pointers.end() ? I.Operands[0] : Pointer->second->Operands[0]));
			if (Known != Memory.end() && !bHandle)
			{
				Known->second.bOrderSeen = true;
			}
		}
	}
	for (const auto& [Variable, Shared] : Memory)
	{
		const bool bCommutes = !Shared.bOrderSeen && Shared.Kinds.size() == 1 && Shared.Widths.size() == 1;
		Use.bInOrder = Use.bInOrder || !bCommutes;
		if (bCommutes)
		{
			Use.Commuting[Variable] = *Shared.Kinds.begin();
		}
	}
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const bool bWaveInput =
			Variable.BuiltIn == BuiltInSubgroupSize || Variable.BuiltIn == BuiltInSubgroupLocalInvocationId;
		Use.bGroups = Use.bGroups || (Variable.Storage == StorageWorkgroup && Used.count(Variable.Id));
		Use.bWaves = Use.bWaves || (bWaveInput && Used.count(Variable.Id));
	}
	Use.bWaves = Use.bWaves || Use.bInOrder;
	Use.bGroups = Use.bGroups || Use.bWaves;
	return Use;
}

const FSpirvInstruction* FindBarrier(const FSpirvModule& Module, const FStructRegion& Region)
{
	for (const FStructNode& Node : Region.Nodes)
	{
		if (Node.Kind == EStructNode::Block)
		{
			const std::vector<FSpirvInstruction>& Instructions = Module.GetBlock(Node.Label).Instructions;
			const auto Found = std::find_if(Instructions.begin(), Instructions.end(),
				[](const FSpirvInstruction& I) { return I.Op == OpControlBarrier; });
			if (Found != Instructions.end())
			{
				return &*Found;
			}
		}
		for (const FStructRegion& Inner : Node.Regions)
		{
			if (const FSpirvInstruction* const Found = FindBarrier(Module, Inner))
			{
				return Found;
			}
		}
	}
	return nullptr;
}

} // namespace Drydock
