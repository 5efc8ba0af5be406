// Finds what needs quads, and turns discarding into going on as a helper.
#include "SpirvQuads.h"

#include <algorithm>
#include <unordered_map>

namespace Drydock
{

using namespace Spirv;

namespace
{

bool IsQuadOperation(uint16_t Op)
{
	return IsSpirvDerivative(Op) || Op == OpGroupNonUniformQuadBroadcast || Op == OpGroupNonUniformQuadSwap;
}

template<typename F>
void ForEachInstruction(const FSpirvModule& Module, F f)
{
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		std::for_each(Block.Instructions.begin(), Block.Instructions.end(), f);
	}
}

FSpirvInstruction MakeAfter(const FSpirvInstruction& Before, uint16_t Op, std::vector<uint32_t> Operands)
{
	return {Op, 0, 0, std::move(Operands), Before.File, Before.Line};
}

/** Stores on the way to a discard show only in memory that others read. Variables of the thread keep their values,
 * whether or not an optimiser took these stores away. */
void DropStores(const FSpirvModule& Module, FSpirvBlock& Block)
{
	std::erase_if(Block.Instructions,
		[&Module](const FSpirvInstruction& I)
		{
			const bool bStore = I.Op == OpStore && !I.Operands.empty();
			const uint32_t Storage = bStore ? Module.GetValueType(I.Operands[0]).Storage : StorageUniform;
			return Storage == StorageFunction || Storage == StoragePrivate || Storage == StorageOutput;
		});
}

/** `if (C) { discard; } rest`: goes on with the rest. Ways: how many lead to a block. */
void ContinueBehind(FSpirvModule& Module, std::unordered_map<uint32_t, int>& Ways, FSpirvBlock& Header)
{
	const FSpirvInstruction Branch = Header.Terminator();
	if (Branch.Op != OpBranchConditional || Branch.Operands.size() < 3 || !Header.Merge || Header.IsLoopHeader())
	{
		return;
	}
	const bool bThen = Branch.Operands[2] == Header.Merge;
	if (bThen == (Branch.Operands[1] == Header.Merge))
	{
		return; // two sides, or none
	}
	const uint32_t Label = Branch.Operands[bThen ? 1 : 2];
	if (Module.GetBlock(Label).Terminator().Op != OpKill || Ways[Label] != 1)
	{
		return;
	}
	FSpirvBlock& Kill = Module.Blocks[Module.BlockIndex.at(Label)];
	DropStores(Module, Kill);
	Kill.Instructions.back().Op = OpDemote;
	Kill.Instructions.push_back(MakeAfter(Kill.Instructions.back(), OpBranch, {Header.Merge}));
	const uint32_t Merge = Module.GetBlock(Header.Merge).Label;
	for (FSpirvInstruction& I : Module.Blocks[Module.BlockIndex.at(Merge)].Instructions)
	{
		for (size_t k = 0; I.Op == OpPhi && k + 1 < I.Operands.size(); k += 2)
		{
			if (I.Operands[k + 1] == Header.Label)
			{
				I.Operands.push_back(I.Operands[k]);
				I.Operands.push_back(Kill.Label);
				break;
			}
		}
	}
}

} // namespace

std::set<uint32_t> FindImplicitSamples(const FSpirvModule& Module)
{
	std::set<uint32_t> Textures;
	std::unordered_map<uint32_t, uint32_t> Sources; // of handles
	ForEachInstruction(Module,
		[&](const FSpirvInstruction& I)
		{
			if (I.Op == OpSampledImage || I.Op == OpLoad)
			{
				Sources[I.Result] = I.Operands.at(0);
			}
			if (ChoosesSpirvLevel(I.Op))
			{
				const auto Pair = Sources.find(I.Operands.at(0));
				const auto Load = Sources.find(Pair == Sources.end() ? I.Operands[0] : Pair->second);
				Textures.insert(Load == Sources.end() ? I.Operands[0] : Load->second);
			}
		});
	return Module.ExecutionModel == ExecutionModelFragment ? Textures : std::set<uint32_t>();
}

bool RunsTogether(uint32_t ExecutionModel, uint16_t Op)
{
	return ExecutionModel == ExecutionModelCompute ? IsSpirvWave(Op)
												   : ExecutionModel == ExecutionModelFragment && IsQuadOperation(Op);
}

bool IsQuadStep(const FSpirvInstruction& I)
{
	return IsQuadOperation(I.Op) || ChoosesSpirvLevel(I.Op);
}

void RunByQuads(FSpirvModule& Module)
{
	if (Module.bQuads || Module.ExecutionModel != ExecutionModelFragment)
	{
		return;
	}
	Module.bQuads = true;
	Module.LocalSize[0] = Module.LocalSize[1] = 2;
	std::vector<uint32_t> Discarding; // functions, by their first block
	for (const FSpirvFunction& Function : Module.Functions)
	{
		const FSpirvBlock& First = Module.Blocks.at(Function.FirstBlock);
		if (First.Instructions.size() == 1 && First.Terminator().Op == OpKill)
		{
			Discarding.push_back(Function.FirstBlock);
		}
	}
	std::unordered_map<uint32_t, int> Ways;
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const uint32_t Label : GetSuccessors(Block.Terminator()))
		{
			++Ways[Label];
		}
	}
	for (FSpirvBlock& Block : Module.Blocks)
	{
		ContinueBehind(Module, Ways, Block);
	}
	for (const uint32_t Index : Discarding)
	{
		std::vector<FSpirvInstruction>& Instructions = Module.Blocks[Index].Instructions;
		Instructions.back().Op = OpDemote;
		Instructions.push_back(MakeAfter(Instructions.back(), OpReturn, {}));
	}
}

void RunByQuadsWhereUsed(FSpirvModule& Module)
{
	bool bUses = false;
	ForEachInstruction(
		Module, [&](const FSpirvInstruction& I) { bUses = bUses || IsQuadOperation(I.Op) || I.Op == OpDemote; });
	if (bUses)
	{
		RunByQuads(Module);
	}
}

} // namespace Drydock
