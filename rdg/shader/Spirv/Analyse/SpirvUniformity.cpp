// Finds by a fixpoint which values differ between lanes. Source of the idea of divergence analysis over structured
// control flow: Coutinho et al., "Divergence Analysis and Optimizations" (PACT 2011).
#include "SpirvUniformity.h"

#include "SpirvFlow.h"
#include "SpirvGroups.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

bool FSpirvUniformity::IsVarying(uint32_t Value, uint32_t Scalar) const
{
	const auto Found = Varying.find(Value);
	return Found != Varying.end() && Scalar < Found->second.size() && Found->second[Scalar];
}

bool FSpirvUniformity::IsAnyVarying(uint32_t Value) const
{
	const auto Found = Varying.find(Value);
	return Found != Varying.end() && std::find(Found->second.begin(), Found->second.end(), true) != Found->second.end();
}

namespace
{

/** The ways of control from a block to open labels, which are named by index. */
struct FWays
{
	std::set<size_t> Ends;
	std::set<uint32_t> Blocks;
};

/** Labels further in than Stop are walked through. */
FWays FollowWays(
	const FSpirvModule& Module, uint32_t Start, const std::unordered_map<uint32_t, size_t>& Open, size_t Stop)
{
	FWays Ways;
	std::vector<uint32_t> Work{Start};
	while (!Work.empty())
	{
		const uint32_t Current = Work.back();
		Work.pop_back();
		const auto Entry = Open.find(Current);
		if (Entry != Open.end())
		{
			Ways.Ends.insert(Entry->second);
		}
		if ((Entry == Open.end() || Entry->second > Stop) && Ways.Blocks.insert(Current).second)
		{
			const std::vector<uint32_t> Next = GetSuccessors(Module.GetBlock(Current).Terminator());
			Work.insert(Work.end(), Next.begin(), Next.end());
		}
	}
	return Ways;
}

/** The ways of lanes that part at a branch, until they meet again. */
struct FSpread : FWays
{
	size_t Join = 0;     // the open label at which they meet: the outermost that any of them can reach
	size_t NumToOwn = 0; // ways that lead to the branch's own merge block
};

/** Own is the index of the branch's own merge block, or the number of open labels if it has none. */
FSpread FindSpread(
	const FSpirvModule& Module, const FSpirvBlock& Branch, const std::vector<FOpenLabel>& Open, size_t Own)
{
	std::unordered_map<uint32_t, size_t> IndexOf; // a label may be open twice: the outer one counts
	for (size_t i = 0; i < Open.size(); ++i)
	{
		IndexOf.emplace(Open[i].Label, i);
	}
	FSpread Spread;
	Spread.Join = Open.size();
	for (bool bAgain = true; bAgain;)
	{
		const size_t Stop = Spread.Join;
		Spread.Blocks.clear();
		Spread.NumToOwn = 0;
		for (const uint32_t Successor : GetSuccessors(Branch.Terminator()))
		{
			const FWays Ways = FollowWays(Module, Successor, IndexOf, Stop);
			Spread.Ends.insert(Ways.Ends.begin(), Ways.Ends.end());
			Spread.Blocks.insert(Ways.Blocks.begin(), Ways.Blocks.end());
			Spread.NumToOwn += Ways.Ends.count(Own);
		}
		Spread.Join = Spread.Ends.empty() ? Stop : *Spread.Ends.begin();
		bAgain = Spread.Join != Stop && Spread.Join != Own;
	}
	return Spread;
}

} // namespace

class FUniformityAnalysis
{
public:
	FUniformityAnalysis(const FSpirvModule& InModule, const FSpirvStructure& InStructure)
		: Module(InModule)
		, Structure(InStructure)
		, Tables(FindConstantTables(InModule))
		, bGroups(FindGroupUse(InModule).bGroups)
		, SettledReads(FindSettledReads(InModule))
	{
	}

	FSpirvUniformity Run();

private:
	void Visit(const FSpirvBlock& Block, const FSpirvInstruction& I);
	void VisitLoad(const FSpirvInstruction& I);
	void VisitStore(uint32_t Pointer, bool bValueVaries, uint32_t Block);
	void VisitUses(const FSpirvBlock& Block, const FSpirvInstruction& I);
	void UseOutsideOfLoop(uint32_t Value, uint32_t Block);
	void SpreadDivergence(uint32_t Block);
	void Mark(uint32_t Value, uint32_t Scalar);
	void MarkAll(uint32_t Value);
	bool IsInputVarying(const FSpirvVariable& Variable, uint32_t Scalar) const;
	uint32_t SizeOf(uint32_t Value) const { return std::max(1u, Module.GetValueType(Value).NumScalars); }
	const FSpirvInstruction* FindChain(uint32_t Pointer) const
	{
		const auto Found = Chains.find(Pointer);
		return Found == Chains.end() ? nullptr : Found->second;
	}
	template<typename TSet>
	void Insert(TSet& Set, uint32_t Id)
	{
		bChanged = Set.insert(Id).second || bChanged;
	}

	const FSpirvModule& Module;
	const FSpirvStructure& Structure;
	const std::map<uint32_t, uint32_t> Tables;
	const bool bGroups;                             // lanes are any threads of one group, not neighbours in a row
	const std::set<uint32_t> SettledReads;          // of groupshared memory, which nobody writes meanwhile
	std::unordered_map<uint32_t, uint32_t> BlockOf; // value -> label of the block that defines it
	std::unordered_map<uint32_t, const FSpirvInstruction*> Chains;
	std::set<uint32_t> DivergentBranches; // blocks whose divergence has been spread: it only depends on the structure
	FSpirvUniformity Result;
	bool bChanged = false;
};

void FUniformityAnalysis::Mark(uint32_t Value, uint32_t Scalar)
{
	std::vector<bool>& Flags = Result.Varying[Value];
	Flags.resize(SizeOf(Value), false);
	if (Scalar < Flags.size() && !Flags[Scalar])
	{
		Flags[Scalar] = true;
		bChanged = true;
	}
}

void FUniformityAnalysis::MarkAll(uint32_t Value)
{
	std::vector<bool>& Flags = Result.Varying[Value];
	Flags.resize(SizeOf(Value), false);
	if (std::find(Flags.begin(), Flags.end(), false) != Flags.end())
	{
		Flags.assign(Flags.size(), true);
		bChanged = true;
	}
}

bool FUniformityAnalysis::IsInputVarying(const FSpirvVariable& Variable, uint32_t Scalar) const
{
	if (bGroups)
	{
		const bool bOne = Scalar < 3 && Module.LocalSize[Scalar] == 1;
		const bool bSame = Variable.BuiltIn == BuiltInWorkgroupId || Variable.BuiltIn == BuiltInSubgroupSize;
		return !bSame && (Module.GetType(Variable.Type).NumScalars == 1 || !bOne);
	}
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
	case BuiltInWorkgroupId:
	case BuiltInLocalInvocationId:
	case BuiltInFragCoord:
		return Scalar == 0 || (Module.bQuads && Scalar == 1); // lanes lie in a row, or in two
	case BuiltInFrontFacing:
		return false;
	default:
		return true;
	}
}

void FUniformityAnalysis::VisitLoad(const FSpirvInstruction& I)
{
	const FSpirvInstruction* Chain = FindChain(I.Operands[0]);
	const FSpirvVariable* Variable = Module.FindVariable(Chain ? Chain->Operands[0] : I.Operands[0]);
	if (!Variable || Module.GetType(I.Type).NumScalars == 0)
	{
		return;
	}
	if (Chain && Result.IsAnyVarying(Chain->Result))
	{
		MarkAll(I.Result);
		return;
	}
	switch (Variable->Storage)
	{
	case StorageFunction:
	case StoragePrivate:
		if (!Tables.count(Variable->Id) && Result.IsVariableVarying(Variable->Id))
		{
			MarkAll(I.Result);
		}
		break;
	case StorageWorkgroup:
		if (!SettledReads.count(I.Result))
		{
			MarkAll(I.Result);
		}
		break;
	case StorageOutput:
		MarkAll(I.Result);
		break;
	case StorageUniform:
	case StorageStorageBuffer:
		// Packs of a group read one after the other, and one may have written in between.
		if (bGroups && Module.GetType(Variable->Type).bBufferBlock &&
			!Module.GetType(Variable->Type).Members[0].bNonWritable)
		{
			MarkAll(I.Result);
		}
		break;
	case StorageInput:
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			// The only chains into inputs are single components.
			const uint32_t Scalar = Chain && Chain->Operands.size() == 2 && Module.FindConstant(Chain->Operands[1])
										? Module.GetConstantScalar(Chain->Operands[1])
										: i;
			if (IsInputVarying(*Variable, Scalar) || (Chain && Chain->Operands.size() > 2))
			{
				Mark(I.Result, i);
			}
		}
		break;
	default:
		break;
	}
}

void FUniformityAnalysis::VisitStore(uint32_t Pointer, bool bValueVaries, uint32_t Block)
{
	const FSpirvInstruction* Chain = FindChain(Pointer);
	const uint32_t Variable = Chain ? Chain->Operands[0] : Pointer;
	if (bValueVaries || (Chain && Result.IsAnyVarying(Pointer)) || Result.IsDivergentBlock(Block))
	{
		Insert(Result.VaryingVariables, Variable);
	}
}

void FUniformityAnalysis::Visit(const FSpirvBlock& Block, const FSpirvInstruction& I)
{
	const auto Copy = [this, &I](uint32_t To, uint32_t Value, uint32_t From)
	{
		if (From == GAnyScalar ? Result.IsAnyVarying(Value) : Result.IsVarying(Value, From))
		{
			Mark(I.Result, To);
		}
	};
	const uint32_t Size = I.Result ? SizeOf(I.Result) : 0;
	switch (I.Op)
	{
	case OpPhi:
	{
		bool bSame = true;
		for (size_t k = 0; k < I.Operands.size(); k += 2)
		{
			bSame = bSame && I.Operands[k] == I.Operands[0];
			for (uint32_t i = 0; i < Size; ++i)
			{
				Copy(i, I.Operands[k], i);
			}
		}
		if (!bSame && Result.IsDivergentJoin(Block.Label))
		{
			MarkAll(I.Result);
		}
		break;
	}
	case OpLoad:
		VisitLoad(I);
		break;
	case OpStore:
		VisitStore(I.Operands[0], Result.IsAnyVarying(I.Operands[1]), Block.Label);
		break;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageDrefGather:
	case OpImageGather:
	case OpImageFetch:
	case OpImageRead:
		MarkAll(I.Result);
		break;
	case OpExtInst:
		if (I.Operands[1] == ExtModf)
		{
			VisitStore(I.Operands[3], Result.IsAnyVarying(I.Operands[2]), Block.Label);
		}
		ForEachFlow(Module, I, Copy);
		break;
	case OpImageWrite:
	case OpSampledImage:
	case OpImage:
	case OpFunctionCall:
	case OpArrayLength:
	case OpImageQueryLevels:
	case OpBranch:
	case OpKill:
	case OpReturn:
	case OpUnreachable:
		break;
	case OpBranchConditional:
	case OpSwitch:
		if (Result.IsAnyVarying(I.Operands[0]))
		{
			SpreadDivergence(Block.Label);
		}
		break;
	default:
		if ((IsSpirvAtomic(I.Op) || IsSpirvWave(I.Op) || IsSpirvDerivative(I.Op)) && I.Result)
		{
			MarkAll(I.Result);
		}
		ForEachFlow(Module, I, Copy);
		break;
	}
}

void FUniformityAnalysis::UseOutsideOfLoop(uint32_t Value, uint32_t Block)
{
	const auto Defined = BlockOf.find(Value);
	if (Defined == BlockOf.end())
	{
		return;
	}
	if (const FSpirvInstruction* Chain = FindChain(Value))
	{
		for (size_t i = 1; i < Chain->Operands.size(); ++i)
		{
			UseOutsideOfLoop(Chain->Operands[i], Block);
		}
	}
	const auto Inside = Structure.Loops.find(Defined->second);
	const auto Outside = Structure.Loops.find(Block);
	if (Inside == Structure.Loops.end() || Outside == Structure.Loops.end())
	{
		return;
	}
	for (const uint32_t Loop : Inside->second)
	{
		const bool bLeft = std::find(Outside->second.begin(), Outside->second.end(), Loop) == Outside->second.end();
		if (bLeft && Result.IsDivergentLoop(Loop))
		{
			MarkAll(Value); // each lane keeps what it had when it left
			return;
		}
	}
}

void FUniformityAnalysis::VisitUses(const FSpirvBlock& Block, const FSpirvInstruction& I)
{
	if (I.Op == OpPhi)
	{
		for (size_t k = 0; k < I.Operands.size(); k += 2)
		{
			UseOutsideOfLoop(I.Operands[k], I.Operands[k + 1]);
		}
		return;
	}
	for (const uint32_t Operand : I.Operands) // a literal that looks like an id costs a vector at worst
	{
		UseOutsideOfLoop(Operand, Block.Label);
	}
}

void FUniformityAnalysis::SpreadDivergence(uint32_t Label)
{
	const auto Found = Structure.OpenLabels.find(Label);
	if (Found == Structure.OpenLabels.end() || !DivergentBranches.insert(Label).second)
	{
		return;
	}
	const FSpirvBlock& Block = Module.GetBlock(Label);
	std::vector<FOpenLabel> Open = Found->second;
	const auto IsOwn = [&Block](const FOpenLabel& Entry)
	{
		return Block.Merge && !Block.IsLoopHeader() && Entry.Label == Block.Merge;
	};
	const size_t Own = size_t(std::find_if(Open.begin(), Open.end(), IsOwn) - Open.begin());
	Open.resize(std::min(Own + 1, Open.size())); // what follows are the cases of this very switch
	if (Block.Terminator().Op == OpSwitch)
	{
		for (const uint32_t Case : GetSuccessors(Block.Terminator()))
		{
			Insert(Result.DivergentJoins, Case); // by falling through
		}
	}
	const FSpread Spread = FindSpread(Module, Block, Open, Own);
	for (const uint32_t Inside : Spread.Blocks)
	{
		Insert(Result.DivergentBlocks, Inside);
	}
	for (const size_t Index : Spread.Ends)
	{
		const bool bBackEdge = Open[Index].Label == Open[Index].Loop;
		const bool bOneWayOnly = Index == Own && Spread.Join == Own && Spread.NumToOwn < 2;
		if (!bBackEdge && !bOneWayOnly)
		{
			Insert(Result.DivergentJoins, Open[Index].Label);
		}
	}
	for (size_t i = Spread.Join; i < Open.size(); ++i)
	{
		if (Open[i].bLoopMerge)
		{
			Insert(Result.DivergentLoops, Open[i].Loop);
		}
	}
}

FSpirvUniformity FUniformityAnalysis::Run()
{
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Result)
			{
				BlockOf[I.Result] = Block.Label;
			}
			if (I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain)
			{
				Chains[I.Result] = &I;
			}
		}
	}
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		// One copy for all packs would be written once by each.
		if (bGroups && !Tables.count(Variable.Id) &&
			(Variable.Storage == StorageFunction || Variable.Storage == StoragePrivate))
		{
			Result.VaryingVariables.insert(Variable.Id);
		}
	}
	do
	{
		bChanged = false;
		for (const FSpirvBlock& Block : Module.Blocks)
		{
			for (const FSpirvInstruction& I : Block.Instructions)
			{
				Visit(Block, I);
				VisitUses(Block, I);
			}
		}
	} while (bChanged);
	return std::move(Result);
}

FSpirvUniformity AnalyzeUniformity(const FSpirvModule& Module, const FSpirvStructure& Structure)
{
	return FUniformityAnalysis(Module, Structure).Run();
}

} // namespace Drydock
