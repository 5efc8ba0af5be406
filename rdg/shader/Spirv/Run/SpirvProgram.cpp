// Gives every id of a module its words.
#include "SpirvProgram.h"

#include "SpirvQuads.h"
#include "SpirvScalarMath.h"
#include "SpirvTurns.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

uint32_t FSpirvProgram::WordsOf(uint32_t TypeId) const
{
	const FSpirvType& Type = Module.GetType(TypeId);
	return Type.Kind == ESpirvType::Void                                        ? 0
		   : Type.Kind == ESpirvType::Image || Type.Kind == ESpirvType::Sampler ? 1
		   : Type.Kind == ESpirvType::SampledImage                              ? 2
		   : Type.Kind == ESpirvType::Pointer                                   ? GSpirvPointerWords
																				: Type.NumScalars;
}

uint32_t FSpirvProgram::BlockOf(uint32_t Label) const
{
	const uint32_t Index = Label < BlockOfLabel.size() ? BlockOfLabel[Label] : GNoSpirvWord;
	if (Index == GNoSpirvWord)
	{
		Module.Fail("SPIR-V: id " + std::to_string(Label) + " is not a block");
	}
	return Index;
}

uint32_t FSpirvProgram::Allocate(uint32_t Id, uint32_t Size)
{
	const uint32_t First = NumWords;
	FirstWords.at(Id) = First;
	NumWords += Size;
	return First;
}

FSpirvProgram::FSpirvProgram(const FSpirvModule& InModule)
	: Module(InModule)
	, Groups(FindGroupUse(InModule))
	, FirstWords(InModule.Bound, GNoSpirvWord)
	, BlockOfLabel(InModule.Bound, GNoSpirvWord)
{
	for (const auto& [Label, Index] : Module.BlockIndex)
	{
		BlockOfLabel.at(Label) = Index;
	}
	for (const auto& [Id, Constant] : Module.Constants)
	{
		Allocate(Id, uint32_t(Constant.Scalars.size()));
	}
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		Allocate(Variable.Id, GSpirvPointerWords);
		const ESpirvType Kind = Module.GetType(Variable.Type).Kind;
		const bool bHandle = Kind == ESpirvType::Image || Kind == ESpirvType::Sampler;
		const bool bBuffer = Variable.Storage == StorageUniform || Variable.Storage == StorageStorageBuffer;
		const uint32_t Size = bHandle ? 1 : bBuffer ? 0 : Module.GetType(Variable.Type).NumScalars;
		if (!bBuffer && !Size)
		{
			Module.Fail("'" + Variable.Name + "' holds textures or buffers inside a struct or an array");
		}
		const bool bShared = Variable.Storage == StorageWorkgroup;
		Memory.push_back({bShared ? Groupshared.Size : NumWords, Size});
		(bShared ? Groupshared.Size : NumWords) += Size;
	}
	Groupshared.First = NumWords;
	NumWords += Groupshared.Size;
	for (size_t i = 0; i < Memory.size(); ++i)
	{
		Memory[i].First += Module.Variables[i].Storage == StorageWorkgroup ? Groupshared.First : 0;
	}
	for (const FSpirvFunction& Function : Module.Functions)
	{
		FSpirvProgramFunction& Laid = Functions.emplace_back();
		Laid.FirstBlock = Function.FirstBlock;
		for (const uint32_t Parameter : Function.Parameters)
		{
			const uint32_t Size = WordsOf(Module.GetValueTypeId(Parameter));
			Laid.Parameters.push_back(Allocate(Parameter, Size));
			Laid.Sizes.push_back(Size);
		}
		EntryBlock = Function.Id == Module.EntryFunction ? Function.FirstBlock : EntryBlock;
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Result)
			{
				Allocate(I.Result, WordsOf(I.Type));
			}
		}
	}
	const FSpirvTurns Turns(Module);
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		AddBlock(Block);
		Blocks.back().bCounted = Block.IsLoopHeader() && !Turns.Find(Block.Label);
	}
	FindVariableNames();
}

void FSpirvProgram::FindVariableNames()
{
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const bool bMadeUp = Variable.Name == "param" || Variable.Name == "indexable" ||
							 Variable.Name.starts_with("flattenTemp") || Variable.Name.starts_with("@");
		VariableNames.push_back(bMadeUp ? std::string() : Variable.Name);
	}
	for (const FSpirvStep& Step : Steps)
	{
		const bool bCall = Step.I->Op == OpFunctionCall && Step.Function != ~0u;
		for (size_t k = 1; bCall && k < Step.I->Operands.size(); ++k)
		{
			const auto Argument = Module.VariableIndex.find(Step.I->Operands[k]);
			const auto Name = Module.Names.find(Module.Functions[Step.Function].Parameters[k - 1]);
			if (Argument != Module.VariableIndex.end() && Name != Module.Names.end() &&
				VariableNames[Argument->second].empty())
			{
				VariableNames[Argument->second] = Name->second;
			}
		}
	}
}

void FSpirvProgram::AddBlock(const FSpirvBlock& Block)
{
	FSpirvProgramBlock& Laid = Blocks.emplace_back();
	Laid.FirstStep = uint32_t(Steps.size());
	for (const FSpirvInstruction& I : Block.Instructions)
	{
		if (I.Op != OpPhi)
		{
			AddStep(I);
			continue;
		}
		for (size_t k = 0; k + 1 < I.Operands.size(); k += 2)
		{
			const uint32_t Source = WordOf(I.Operands[k]);
			if (Source != GNoSpirvWord)
			{
				Laid.Edges.push_back({I.Operands[k + 1], WordOf(I.Result), Source, WordsOf(I.Type)});
			}
		}
	}
	Laid.NumSteps = uint32_t(Steps.size()) - Laid.FirstStep;
}

void FSpirvProgram::FindKinds(FSpirvStep& Step) const
{
	const FSpirvInstruction& I = *Step.I;
	const size_t First = I.Op == OpExtInst   ? 2
						 : I.Op == OpSelect  ? 1
						 : IsSpirvWave(I.Op) ? (HasGroupOperation(I.Op) ? 2 : 1)
											 : 0;
	const auto IsNumbers = [this](uint32_t TypeId)
	{
		const FSpirvType& Type = Module.GetType(TypeId);
		return IsSpirvScalar(Type.Kind) || Type.Kind == ESpirvType::Vector || Type.Kind == ESpirvType::Matrix;
	};
	const bool bValue = First < I.Operands.size() && WordOf(I.Operands[First]) != GNoSpirvWord;
	const uint32_t Operand = bValue ? Module.GetValueTypeId(I.Operands[First]) : 0;
	Step.Kind = bValue && IsNumbers(Operand) ? Module.GetScalarKind(Operand, 0) : ESpirvType::None;
	Step.bNarrow =
		I.Type && !MovesSpirvNumbers(I.Op) && IsNumbers(I.Type) && GetSpirvBytes(Module.GetScalarKind(I.Type, 0)) == 2;
}

void FSpirvProgram::AddStep(const FSpirvInstruction& I)
{
	FSpirvStep Step;
	Step.I = &I;
	Step.To = I.Result ? WordOf(I.Result) : GNoSpirvWord;
	Step.Size = I.Type ? WordsOf(I.Type) : 0;
	Step.FirstArg = uint32_t(Args.size());
	for (const uint32_t Operand : I.Operands)
	{
		const uint32_t Word = WordOf(Operand);
		Args.push_back(Word);
		ArgSizes.push_back(Word == GNoSpirvWord ? 0 : WordsOf(Module.GetValueTypeId(Operand)));
	}
	FindKinds(Step);
	if (I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain)
	{
		const FSpirvType& Base = Module.GetValueType(I.Operands.at(0));
		const bool bBytes = Base.Storage == StorageUniform || Base.Storage == StorageStorageBuffer;
		Step.Place = uint32_t(Places.size());
		Places.push_back(FollowChain(Module, Base.Element, bBytes, I));
	}
	if (I.Op == OpLoad || I.Op == OpStore || IsSpirvAtomic(I.Op))
	{
		// A whole variable or parameter has no chain: its place begins at 0.
		const FSpirvType& Base = Module.GetValueType(I.Operands.at(0));
		const bool bBytes = Base.Storage == StorageUniform || Base.Storage == StorageStorageBuffer;
		if (bBytes)
		{
			const auto Chain = std::find_if(Steps.rbegin(), Steps.rend(),
				[&I](const FSpirvStep& Earlier) { return Earlier.I->Result == I.Operands[0]; });
			Step.Place = Chain == Steps.rend() ? uint32_t(Places.size()) : Chain->Place;
			if (Chain == Steps.rend())
			{
				Places.push_back(FollowChain(Module, Base.Element, true, FSpirvInstruction()));
			}
		}
	}
	if (I.Op == OpFunctionCall)
	{
		const auto Found = std::ranges::find(Module.Functions, I.Operands.at(0), &FSpirvFunction::Id);
		const bool bKnown = Found != Module.Functions.end();
		Step.Function = bKnown ? uint32_t(Found - Module.Functions.begin()) : ~0u;
		if (bKnown && Functions[Step.Function].Parameters.size() + 1 != I.Operands.size())
		{
			Module.Fail("SPIR-V: a call with the wrong number of arguments", &I);
		}
	}
	const bool bAtomic = IsSpirvAtomic(I.Op);
	const bool bMemory = I.Op == OpLoad && Module.GetType(I.Type).NumScalars;
	const uint32_t Storage = bMemory ? Module.GetValueType(I.Operands[0]).Storage : 0;
	const bool bWave = IsSpirvWave(I.Op);
	Step.bSync = I.Op == OpControlBarrier || bWave || (Groups.bWaves && bAtomic) || (Module.bQuads && IsQuadStep(I));
	Step.bOfOthers = (Groups.bGroups || Module.bQuads) && I.Result &&
					 (bAtomic || bWave || IsSpirvDerivative(I.Op) || I.Op == OpImageRead ||
						 (bMemory && Storage == StorageWorkgroup) ||
						 (bMemory && Step.Place != ~0u && Places[Step.Place].ElementStride));
	Steps.push_back(Step);
}

} // namespace Drydock
