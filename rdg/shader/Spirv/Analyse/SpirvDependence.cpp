// Follows by a fixpoint what values depend on.
#include "SpirvDependence.h"

#include "SpirvFlow.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

uint8_t FSpirvDependence::Get(uint32_t Value, uint32_t Scalar) const
{
	const auto Found = Bits.find(Value);
	return Found == Bits.end() || Scalar >= Found->second.size() ? 0 : Found->second[Scalar];
}

uint8_t FSpirvDependence::GetAll(uint32_t Value) const
{
	uint8_t All = 0;
	const auto Found = Bits.find(Value);
	for (size_t i = 0; Found != Bits.end() && i < Found->second.size(); ++i)
	{
		All |= Found->second[i];
	}
	return All;
}

class FDependenceAnalysis
{
public:
	FDependenceAnalysis(const FSpirvModule& InModule, const FSpirvStructure& InStructure)
		: Module(InModule)
		, Structure(InStructure)
		, Tables(FindConstantTables(InModule))
	{
	}

	FSpirvDependence Run();

private:
	std::vector<uint32_t> FindConditions(const FStructRegion& Region);
	void Visit(const FSpirvBlock& Block, const FSpirvInstruction& I);
	uint8_t GetLoaded(const FSpirvInstruction& I, uint32_t Scalar) const;
	uint8_t GetChoice(uint32_t Label) const;
	void Add(uint32_t Value, uint32_t Scalar, uint8_t New);
	uint32_t SizeOf(uint32_t Value) const { return std::max(1u, Module.GetValueType(Value).NumScalars); }

	const FSpirvModule& Module;
	const FSpirvStructure& Structure;
	const std::map<uint32_t, uint32_t> Tables;
	std::unordered_map<uint32_t, const FSpirvInstruction*> Chains;
	/** Labels where ways meet: what decides between the ways. Headers of loops: all that is decided inside. */
	std::unordered_map<uint32_t, std::set<uint32_t>> Choices;
	FSpirvDependence Result;
	bool bChanged = false;
};

/** Conditions and selectors in the region and all inside; fills Choices on its way. Jumps only go to labels of the
 *  constructs around them. */
std::vector<uint32_t> FDependenceAnalysis::FindConditions(const FStructRegion& Region)
{
	std::vector<uint32_t> All;
	for (const FStructNode& Node : Region.Nodes)
	{
		std::vector<uint32_t> Conditions;
		if (Node.Kind == EStructNode::If || Node.Kind == EStructNode::Switch)
		{
			Conditions.push_back(Node.Value);
		}
		for (const FStructRegion& Inner : Node.Regions)
		{
			const std::vector<uint32_t> More = FindConditions(Inner);
			Conditions.insert(Conditions.end(), More.begin(), More.end());
		}
		if (Conditions.empty())
		{
			continue;
		}
		std::vector<uint32_t> Labels = {Node.Merge};
		for (const FStructCase& Case : Node.Cases)
		{
			Labels.push_back(Case.Label);
		}
		if (Node.Kind == EStructNode::Loop)
		{
			Labels.push_back(Node.Label);
			Labels.push_back(Node.Continue);
		}
		for (const uint32_t Label : Labels)
		{
			Choices[Label].insert(Conditions.begin(), Conditions.end());
		}
		All.insert(All.end(), Conditions.begin(), Conditions.end());
	}
	return All;
}

void FDependenceAnalysis::Add(uint32_t Value, uint32_t Scalar, uint8_t New)
{
	std::vector<uint8_t>& Bits = Result.Bits[Value];
	Bits.resize(SizeOf(Value), 0);
	if (Scalar < Bits.size() && (Bits[Scalar] | New) != Bits[Scalar])
	{
		Bits[Scalar] |= New;
		bChanged = true;
	}
}

uint8_t FDependenceAnalysis::GetChoice(uint32_t Label) const
{
	uint8_t Bits = 0;
	const auto Found = Choices.find(Label);
	if (Found != Choices.end())
	{
		for (const uint32_t Condition : Found->second)
		{
			Bits |= Result.GetAll(Condition);
		}
	}
	return Bits;
}

uint8_t FDependenceAnalysis::GetLoaded(const FSpirvInstruction& I, uint32_t Scalar) const
{
	const auto Found = Chains.find(I.Operands[0]);
	const FSpirvInstruction* const Chain = Found == Chains.end() ? nullptr : Found->second;
	const FSpirvVariable* const Variable = Module.FindVariable(Chain ? Chain->Operands[0] : I.Operands[0]);
	if (!Variable)
	{
		return DependsOnOther;
	}
	const uint8_t Index = Chain ? Result.GetAll(Chain->Result) : 0;
	if (Variable->Storage == StorageInput)
	{
		if (Chain)
		{
			if (Chain->Operands.size() != 2 || !Module.FindConstant(Chain->Operands[1]))
			{
				return DependsOnOther;
			}
			Scalar = Module.GetConstantScalar(Chain->Operands[1]);
		}
		switch (Variable->BuiltIn)
		{
		case BuiltInGlobalInvocationId:
		case BuiltInWorkgroupId:
		case BuiltInLocalInvocationId:
			return Scalar == 0 ? DependsOnColumn : Scalar == 1 ? DependsOnRow : DependsOnOther;
		case BuiltInFragCoord:
			return Scalar == 0 ? DependsOnColumn : Scalar == 1 ? DependsOnRow : 0;
		case BuiltInFrontFacing:
			return 0;
		case BuiltInNone:
			return Scalar % 2 == 0 ? DependsOnColumn : DependsOnRow;
		default:
			return DependsOnOther;
		}
	}
	const bool bConstants = Variable->Storage == StorageUniform && !Module.GetType(Variable->Type).bBufferBlock;
	return bConstants || Tables.count(Variable->Id) ? Index : uint8_t(DependsOnOther);
}

void FDependenceAnalysis::Visit(const FSpirvBlock& Block, const FSpirvInstruction& I)
{
	if (!I.Result)
	{
		return;
	}
	const auto Copy = [this, &I](uint32_t To, uint32_t Value, uint32_t From)
	{
		Add(I.Result, To, From == GAnyScalar ? Result.GetAll(Value) : Result.Get(Value, From));
	};
	switch (I.Op)
	{
	case OpPhi:
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			Add(I.Result, i, GetChoice(Block.Label));
			for (size_t k = 0; k < I.Operands.size(); k += 2)
			{
				Copy(i, I.Operands[k], i);
			}
		}
		return;
	case OpLoad:
		for (uint32_t i = 0; Module.GetType(I.Type).NumScalars && i < SizeOf(I.Result); ++i)
		{
			Add(I.Result, i, GetLoaded(I, i));
		}
		return;
	case OpImageQueryLevels:
	case OpArrayLength:
		return;
	default:
		if (!ForEachFlow(Module, I, Copy))
		{
			for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
			{
				Add(I.Result, i, DependsOnOther);
			}
		}
		return;
	}
}

FSpirvDependence FDependenceAnalysis::Run()
{
	FindConditions(Structure.Root);
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain)
			{
				Chains[I.Result] = &I;
			}
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
			}
		}
	} while (bChanged);
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		const auto Loops = Structure.Loops.find(Block.Label);
		const bool bInLoop = Loops != Structure.Loops.end() && !Loops->second.empty();
		if (bInLoop && GetChoice(Loops->second.front()) != 0)
		{
			Result.UnsteadyBlocks.insert(Block.Label);
		}
	}
	return std::move(Result);
}

FSpirvDependence AnalyzeDependence(const FSpirvModule& Module, const FSpirvStructure& Structure)
{
	return FDependenceAnalysis(Module, Structure).Run();
}

} // namespace Drydock
