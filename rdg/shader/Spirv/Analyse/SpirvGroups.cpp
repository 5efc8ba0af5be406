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
	return std::ranges::find_if(Module.Variables, [&](const FSpirvVariable& Other)
		{ return Other.Name == Variable->Name && Module.GetType(Other.Type).bBufferBlock; })
		->Id;
}

using FPointers = std::unordered_map<uint32_t, const FSpirvInstruction*>;

template<typename TVisit>
void ForEachInstruction(const FSpirvModule& Module, TVisit Visit)
{
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			Visit(I);
		}
	}
}

/** Instructions whose results lead to a variable, by result. */
FPointers FindPointers(const FSpirvModule& Module)
{
	FPointers Pointers;
	ForEachInstruction(Module,
		[&](const FSpirvInstruction& I)
		{
			if (IsChain(I.Op) || I.Op == OpLoad)
			{
				Pointers[I.Result] = &I;
			}
		});
	return Pointers;
}

/** Values that some instruction uses. A literal that looks like an id is a use too many. */
std::set<uint32_t> FindUsedValues(const FSpirvModule& Module)
{
	std::set<uint32_t> Used;
	// Scope and semantics of an atomic are constants, never its neighbours' results.
	ForEachInstruction(Module, [&](const FSpirvInstruction& I) { Used.insert(I.Operands.begin(), I.Operands.end()); });
	return Used;
}

/** The memory that atomics change, by the variable that stands for it. */
struct FAtomicMemory
{
	std::map<uint32_t, FSharedMemory> Resources; // buffers and textures
	std::map<uint32_t, FSharedMemory> Groupshared;
	bool bOrderSeen = false; // somewhere
};

FAtomicMemory FindAtomicMemory(const FSpirvModule& Module, const FPointers& Pointers, const std::set<uint32_t>& Used)
{
	FAtomicMemory Found;
	ForEachInstruction(Module,
		[&](const FSpirvInstruction& I)
		{
			if (!IsSpirvAtomic(I.Op))
			{
				return;
			}
			const bool bSeen = Used.count(I.Result) || !Commutes(I.Op);
			Found.bOrderSeen = Found.bOrderSeen || bSeen;
			if (const FSpirvVariable* const Variable = FindAtomicVariable(Module, I, Pointers))
			{
				const bool bGroupshared = Variable->Storage == StorageWorkgroup;
				FSharedMemory& Shared =
					(bGroupshared ? Found.Groupshared : Found.Resources)[GetMemoryId(Module, Variable->Id)];
				Shared.Kinds.insert(GetKind(I.Op));
				Shared.Widths.insert(GetSpirvBytes(Module.GetType(Module.GetValueType(I.Operands[0]).Element).Kind));
				Shared.bOrderSeen = Shared.bOrderSeen || bSeen;
			}
		});
	return Found;
}

/** The memory that plain loads and stores reach, by the variable that stands for it. */
std::set<uint32_t> FindPlainMemory(const FSpirvModule& Module, const FPointers& Pointers)
{
	std::set<uint32_t> Found;
	ForEachInstruction(Module,
		[&](const FSpirvInstruction& I)
		{
			const bool bHandle = I.Op == OpLoad && Module.GetType(I.Type).NumScalars == 0;
			const bool bReads = (I.Op == OpLoad && !bHandle) || I.Op == OpImageRead;
			if ((bReads || I.Op == OpStore || I.Op == OpImageWrite) && !I.Operands.empty())
			{
				const auto Pointer = Pointers.find(I.Operands[0]);
				Found.insert(
					GetMemoryId(Module, Pointer == Pointers.end() ? I.Operands[0] : Pointer->second->Operands[0]));
			}
		});
	return Found;
}

bool IsWaveInput(const FSpirvVariable& Variable)
{
	return Variable.BuiltIn == BuiltInSubgroupSize || Variable.BuiltIn == BuiltInSubgroupLocalInvocationId;
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
	const FPointers Pointers = FindPointers(Module);
	const std::set<uint32_t> Used = FindUsedValues(Module);
	const FAtomicMemory Atomics = FindAtomicMemory(Module, Pointers, Used);
	const std::set<uint32_t> Plain = FindPlainMemory(Module, Pointers);
	FSpirvGroupUse Use;
	for (const auto& [Variable, Shared] : Atomics.Resources)
	{
		const bool bOrderSeen = Shared.bOrderSeen || Plain.count(Variable);
		const bool bCommutes = !bOrderSeen && Shared.Kinds.size() == 1 && Shared.Widths.size() == 1;
		Use.bInOrder = Use.bInOrder || !bCommutes;
		if (bCommutes)
		{
			Use.Commuting[Variable] = *Shared.Kinds.begin();
		}
	}
	Use.bWaves =
		Atomics.bOrderSeen || Use.bInOrder ||
		std::ranges::any_of(Atomics.Groupshared, [](const auto& Entry) { return Entry.second.Kinds.size() > 1; });
	ForEachInstruction(Module,
		[&](const FSpirvInstruction& I)
		{
			Use.bGroups = Use.bGroups || I.Op == OpControlBarrier;
			Use.bWaves = Use.bWaves || (IsSpirvWave(I.Op) && Module.ExecutionModel != ExecutionModelFragment);
		});
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const bool bUsed = Used.count(Variable.Id) != 0;
		Use.bGroups = Use.bGroups || (Variable.Storage == StorageWorkgroup && bUsed);
		Use.bWaves = Use.bWaves || (IsWaveInput(Variable) && bUsed);
	}
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
			const auto Found = std::ranges::find(Instructions, OpControlBarrier, &FSpirvInstruction::Op);
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

std::set<uint32_t> FindSettledReads(const FSpirvModule& Module)
{
	const FPointers Pointers = FindPointers(Module);
	const auto Unsettles = [&](const FSpirvInstruction& I)
	{
		const FSpirvVariable* const Target = I.Op == OpStore ? FindAtomicVariable(Module, I, Pointers) : nullptr;
		return IsSpirvAtomic(I.Op) || I.Op == OpFunctionCall || (Target && Target->Storage == StorageWorkgroup);
	};
	std::map<uint32_t, int> Ways; // to a block, less those that come from a settled block
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const uint32_t Next : GetSuccessors(Block.Terminator()))
		{
			++Ways[Next];
		}
	}
	std::set<uint32_t> Reads;
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		bool bSettled = Ways.count(Block.Label) && Ways[Block.Label] == 0;
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			bSettled = (bSettled || I.Op == OpControlBarrier) && !Unsettles(I);
			if (bSettled && I.Op == OpLoad)
			{
				Reads.insert(I.Result);
			}
		}
		for (const uint32_t Next : GetSuccessors(Block.Terminator()))
		{
			Ways[Next] -= bSettled;
		}
	}
	return Reads;
}

} // namespace Drydock
