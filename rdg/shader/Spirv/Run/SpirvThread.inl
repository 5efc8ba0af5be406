// Inputs, blocks and calls of a thread. Source of the instructions' meaning: SPIR-V specification, section 3.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"
#include "Math/ToInteger.h"

#include <numeric>

namespace Drydock
{

using namespace Spirv;

template<typename Real>
TSpirvThread<Real>::TSpirvThread(const FSpirvProgram& InProgram, FSpirvSlotTable InSlots)
	: BlockRuns(InProgram.Blocks.size())
	, Program(InProgram)
	, Table(std::move(InSlots))
	, Words(InProgram.NumWords)
	, CountedTurns(InProgram.Blocks.size())
{
	for (const auto& [Id, Constant] : Program.Module.Constants)
	{
		FWord* const Out = Words.data() + Program.WordOf(Id);
		for (uint32_t i = 0; i < Constant.Scalars.size(); ++i)
		{
			Out[i] = FromSpirvMemory<Real>(GetKind(Constant.Type, i), Constant.Scalars[i]);
		}
	}
	for (size_t i = 0; i < Program.Module.Variables.size(); ++i)
	{
		FWord* const Pointer = Words.data() + Program.WordOf(Program.Module.Variables[i].Id);
		const uint32_t Storage = Program.Module.Variables[i].Storage;
		const bool bBuffer = Storage == StorageUniform || Storage == StorageStorageBuffer;
		Pointer[0] = bBuffer ? 0 : Program.Memory[i].First;
		Pointer[2] = FWord(i);
	}
}

template<typename Real>
void TSpirvThread<Real>::SetObserver(ISpirvObserver* InObserver, bool bInTrackUndefined)
{
	Observer = InObserver;
	Undefined.assign(bInTrackUndefined ? Words.size() : 0, 0);
}

template<typename Real>
void TSpirvThread<Real>::ClearMemory()
{
	std::fill(Undefined.begin(), Undefined.end(), 0u);
	for (size_t i = 0; i < Program.Module.Variables.size(); ++i)
	{
		const FSpirvVariable& Variable = Program.Module.Variables[i];
		const FSpirvMemory& Memory = Program.Memory[i];
		FWord* const Out = Words.data() + Memory.First;
		if (Variable.Storage == StorageUniformConstant)
		{
			Out[0] = FWord(i);
			continue;
		}
		if (Variable.Initializer)
		{
			std::copy_n(Words.data() + Program.WordOf(Variable.Initializer), Memory.Size, Out);
			continue;
		}
		std::fill_n(Out, Memory.Size, FWord(0));
		if (!Undefined.empty() && Variable.Storage != StorageInput)
		{
			std::iota(
				Undefined.begin() + Memory.First, Undefined.begin() + Memory.First + Memory.Size, Memory.First + 1);
		}
	}
}

template<typename Real>
void TSpirvThread<Real>::FillInputs()
{
	for (size_t i = 0; i < Program.Module.Variables.size(); ++i)
	{
		const FSpirvVariable& Variable = Program.Module.Variables[i];
		if (Variable.Storage == StorageInput)
		{
			FillInput(Variable, Words.data() + Program.Memory[i].First);
		}
	}
}

template<typename Real>
void TSpirvThread<Real>::FillInput(const FSpirvVariable& Variable, FWord* Out) const
{
	const int32_t Group[3] = {int32_t(Program.Module.LocalSize[0]), int32_t(Program.Module.LocalSize[1]),
		int32_t(Program.Module.LocalSize[2])};
	const auto Local = [this, &Group](int Axis)
	{
		return uint32_t(Position[Axis] % Group[Axis]);
	};
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Out[Axis] = uint32_t(Position[Axis]);
		}
		return;
	case BuiltInWorkgroupId:
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Out[Axis] = uint32_t(Position[Axis] / Group[Axis]);
		}
		return;
	case BuiltInLocalInvocationId:
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Out[Axis] = Local(Axis);
		}
		return;
	case BuiltInSubgroupSize:
		Out[0] = WaveSize;
		return;
	case BuiltInSubgroupLocalInvocationId:
		Out[0] = Lane;
		return;
	case BuiltInLocalInvocationIndex:
		Out[0] = (Local(2) * uint32_t(Group[1]) + Local(1)) * uint32_t(Group[0]) + Local(0);
		return;
	case BuiltInFragCoord:
		Out[0] = ToSpirvWord<Real>(Real(Position[0]) + Real(0.5));
		Out[1] = ToSpirvWord<Real>(Real(Position[1]) + Real(0.5));
		Out[2] = ToSpirvWord<Real>(Real(0));
		Out[3] = ToSpirvWord<Real>(Real(1));
		return;
	case BuiltInFrontFacing:
		Out[0] = 1;
		return;
	case BuiltInVertexIndex:
		Out[0] = Vertex ? Vertex->VertexId : 0;
		return;
	case BuiltInInstanceIndex:
		Out[0] = Vertex ? Vertex->InstanceId : 0;
		return;
	default:
		break;
	}
	if (Vertex)
	{
		FillAttribute(Variable, Out);
		return;
	}
	const int32_t Index = GetInterpolantIndex(Variable);
	const uint32_t Size = std::min(4u, Program.Module.GetType(Variable.Type).NumScalars);
	const ESpirvType Kind = Program.Module.GetScalarKind(Variable.Type, 0);
	for (uint32_t i = 0; i < Size && Index >= 0 && Args->Interpolants; ++i)
	{
		if (Kind != ESpirvType::Float)
		{
			const double Base = Args->Interpolants[Index].Base[i];
			Out[i] = Kind == ESpirvType::Int ? FWord(uint32_t(int32_t(Base))) : FWord(uint32_t(Base));
			continue;
		}
		Out[i] = ToSpirvWord<Real>(
			Lanes::Interpolate<Real>(Args->Interpolants[Index], int(i), Lanes::TInt<4>(Position[0]), Position[1])[0]);
	}
}

template<typename Real>
void TSpirvThread<Real>::FillAttribute(const FSpirvVariable& Variable, FWord* Out) const
{
	const int32_t Index = GetSemanticIndex(Variable.Semantic, "ATTRIBUTE");
	const ESpirvType Kind = Program.Module.GetScalarKind(Variable.Type, 0);
	const uint32_t Size = std::min(4u, Program.Module.GetType(Variable.Type).NumScalars);
	for (uint32_t i = 0; i < Size && Index >= 0; ++i)
	{
		const double Value = Vertex->Attributes[Index][i];
		Out[i] = Kind == ESpirvType::Float ? ToSpirvWord<Real>(Real(Value))
				 : Kind == ESpirvType::Int ? FWord(uint32_t(ToInteger<int32_t>(Value)))
										   : FWord(ToInteger<uint32_t>(Value));
	}
}

template<typename Real>
void TSpirvThread<Real>::Begin(const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex)
{
	Args = &InArgs;
	Vertex = InVertex;
	std::copy_n(InPosition, 3, Position);
	bDiscarded = bDemoted = bHelper = false;
	Level = 0;
	Taps = 0;
	Calls.clear();
	ClearMemory();
	FillInputs();
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteStep(const FSpirvStep& Step)
{
	bDiscarded = Step.I->Op == OpKill;
	if (bDiscarded || Step.I->Op == OpUnreachable)
	{
		return false;
	}
	Execute(Step);
	return !bDiscarded;
}

template<typename Real>
void TSpirvThread<Real>::Run(
	const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex, uint64_t MaxSteps)
{
	Start(InArgs, InPosition, InVertex);
	while (Advance(MaxSteps))
	{
		ExecuteWaiting();
		StepOver();
	}
}

template<typename Real>
void TSpirvThread<Real>::Start(const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex)
{
	Begin(InArgs, InPosition, InVertex);
	NumSteps = 0;
	Block = Program.EntryBlock;
	At = Program.Blocks[Block].FirstStep;
	++BlockRuns[Block];
}

template<typename Real>
bool TSpirvThread<Real>::Advance(uint64_t MaxSteps)
{
	for (;;)
	{
		const FSpirvStep& Step = Program.Steps[At];
		const uint16_t Op = Step.I->Op;
		if (++NumSteps > MaxSteps)
		{
			Program.Module.Fail("the shader did not end", Step.I);
		}
		if (Step.bSync)
		{
			return true;
		}
		if (IsSpirvTerminator(Op))
		{
			if (!ExecuteTerminator(Step))
			{
				break;
			}
			continue;
		}
		if (Op == OpFunctionCall && ExecuteCall(Step))
		{
			continue;
		}
		Execute(Step);
		if (Step.bHook && Observer)
		{
			Observer->OnStep(*this, Step);
		}
		if (bDiscarded)
		{
			return false;
		}
		++At;
	}
	if (!Undefined.empty() && !bDiscarded)
	{
		CheckOutputs();
	}
	return false;
}

/** False: the step does not call a function of the module. */
template<typename Real>
bool TSpirvThread<Real>::ExecuteCall(const FSpirvStep& Step)
{
	if (Step.Function == ~0u)
	{
		return false;
	}
	const FSpirvProgramFunction& Function = Program.Functions[Step.Function];
	for (size_t k = 0; k < Function.Parameters.size(); ++k)
	{
		const uint32_t Source = Arg(Step, k + 1);
		std::copy_n(Words.data() + Source, Function.Sizes[k], Words.data() + Function.Parameters[k]);
		if (!Undefined.empty())
		{
			std::copy_n(Undefined.begin() + Source, Function.Sizes[k], Undefined.begin() + Function.Parameters[k]);
		}
	}
	Calls.push_back({At, Block});
	if (Observer)
	{
		Observer->OnCall(*this, Step);
	}
	Block = Function.FirstBlock;
	At = Program.Blocks[Block].FirstStep;
	++BlockRuns[Block];
	return true;
}

/** Goes where the step leads; false: it ends the thread. */
template<typename Real>
bool TSpirvThread<Real>::ExecuteTerminator(const FSpirvStep& Step)
{
	const uint16_t Op = Step.I->Op;
	if (Step.bHook && Observer)
	{
		Observer->OnStep(*this, Step);
	}
	bDiscarded = Op == OpKill;
	const bool bReturns = Op == OpReturn || Op == OpReturnValue;
	if (bDiscarded || Op == OpUnreachable || (bReturns && Calls.empty()))
	{
		return false;
	}
	if (!bReturns)
	{
		const uint32_t Target = ChooseTarget(Step);
		const uint32_t From = Block;
		Block = Program.BlockOf(Target);
		EnterBlock(Block, From);
		At = Program.Blocks[Block].FirstStep;
		return true;
	}
	const FCall Call = Calls.back();
	const FSpirvStep& Caller = Program.Steps[Call.Step];
	if (Op == OpReturnValue)
	{
		std::copy_n(Value(Step, 0), Caller.Size, Result(Caller));
		if (!Undefined.empty())
		{
			std::copy_n(Undefined.begin() + Arg(Step, 0), Caller.Size, Undefined.begin() + Caller.To);
		}
	}
	Calls.pop_back();
	if (Observer)
	{
		Observer->OnReturn(*this, Caller);
		if (Caller.bHook)
		{
			Observer->OnStep(*this, Caller);
		}
	}
	Block = Call.Block;
	At = Call.Step + 1;
	return true;
}

template<typename Real>
void TSpirvThread<Real>::EnterBlock(uint32_t To, uint32_t FromBlock)
{
	++BlockRuns[To];
	if (Order)
	{
		const std::vector<uint32_t>& Around = Order->Loops[FromBlock];
		const bool bAgain = std::find(Around.begin(), Around.end(), To) != Around.end();
		Turns[To] = bAgain ? Turns[To] + 1 : 0;
	}
	if (Program.Blocks[To].bCounted)
	{
		CountTurn(To, FromBlock);
	}
	const uint32_t From = Program.Module.Blocks[FromBlock].Label;
	const std::vector<FSpirvEdge>& Edges = Program.Blocks[To].Edges;
	if (Edges.empty())
	{
		return;
	}
	// All phis of a block read before any of them is written.
	Incoming.clear();
	std::vector<uint32_t> IncomingUndefined;
	for (const FSpirvEdge& Edge : Edges)
	{
		if (Edge.From == From)
		{
			Incoming.insert(Incoming.end(), Words.begin() + Edge.Source, Words.begin() + Edge.Source + Edge.Size);
			if (!Undefined.empty())
			{
				IncomingUndefined.insert(IncomingUndefined.end(), Undefined.begin() + Edge.Source,
					Undefined.begin() + Edge.Source + Edge.Size);
			}
		}
	}
	size_t Next = 0;
	for (const FSpirvEdge& Edge : Edges)
	{
		if (Edge.From == From)
		{
			std::copy_n(Incoming.begin() + std::ptrdiff_t(Next), Edge.Size, Words.begin() + Edge.To);
			if (!Undefined.empty())
			{
				std::copy_n(IncomingUndefined.begin() + std::ptrdiff_t(Next), Edge.Size, Undefined.begin() + Edge.To);
			}
			Next += Edge.Size;
		}
	}
}

/** A block that goes back to a header stands behind it. */
template<typename Real>
void TSpirvThread<Real>::CountTurn(uint32_t To, uint32_t FromBlock)
{
	CountedTurns[To] = FromBlock >= To ? CountedTurns[To] + 1 : 0;
	if (Args->Limits && CountedTurns[To] > Args->Limits->LoopTurns)
	{
		const FSpirvInstruction& Header = Program.Module.Blocks[To].Terminator();
		Args->Limits->OnEndlessLoop(
			Program.Module.Files[Header.File].c_str(), Header.Line, Position[0], Position[1], Position[2]);
	}
}

template<typename Real>
uint32_t TSpirvThread<Real>::ChooseTarget(const FSpirvStep& Step) const
{
	const std::vector<uint32_t>& Operands = Step.I->Operands;
	switch (Step.I->Op)
	{
	case OpBranchConditional:
		return Operands[Bits(Step, 0) ? 1 : 2];
	case OpSwitch:
		for (size_t i = 2; i + 1 < Operands.size(); i += 2)
		{
			if (Operands[i] == Bits(Step, 0))
			{
				return Operands[i + 1];
			}
		}
		return Operands[1];
	default:
		return Operands[0];
	}
}

template<typename Real>
void TSpirvThread<Real>::Execute(const FSpirvStep& Step)
{
	std::optional<FScopedDenormals> Doubles;
	if (sizeof(Real) == 4 && Step.Kind == ESpirvType::Double && Step.I->Op != OpFConvert)
	{
		Doubles.emplace(EDenormals::Keep); // where floats flush them
	}
	if (!Undefined.empty())
	{
		FollowUndefined(Step);
	}
	if (Step.bOfOthers && Log && bReplay && ExecuteFromLog(Step))
	{
		return;
	}
	if (Step.bSync && ChoosesSpirvLevel(Step.I->Op) && Log && bReplay)
	{
		Level = ToSpirvReal<Real>(TakeFromLog(Step));
	}
	switch (Step.I->Op)
	{
	case OpLoad:
		Load(Step);
		break;
	case OpStore:
		if (Step.Place != ~0u)
		{
			StoreBytes(Step);
		}
		else
		{
			Store(Step, uint32_t(Value(Step, 0)[0]), Value(Step, 1), SizeOf(Step, 1));
		}
		return;
	case OpAccessChain:
	case OpInBoundsAccessChain:
		ExecuteChain(Step);
		return;
	case OpFunctionCall:
	case OpDemote:
		Discard();
		return;
	case OpArrayLength:
		ArrayLength(Step);
		return;
	case OpBitcast:
		ExecuteBitcast(Step);
		return;
	case OpExtInst:
		ExecuteExtended(Step);
		Narrow(Step, Result(Step));
		return;
	default:
	{
		const bool bDouble = Step.Kind == ESpirvType::Double;
		if (!ExecuteComposite(Step) && !(bDouble ? ExecuteMatrix<double>(Step) : ExecuteMatrix<Real>(Step)) &&
			!ExecuteImage(Step) && !ExecuteAtomic(Step))
		{
			ExecuteScalars(Step);
		}
		Narrow(Step, Step.bNarrow ? Result(Step) : nullptr);
		break;
	}
	}
	Note(Step);
}

} // namespace Drydock
