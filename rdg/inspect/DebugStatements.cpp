// Writes one statement for each instruction.
#include "DebugEmitterImpl.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

std::optional<FDebugPath> FDebugEmitter::FindPath(uint32_t Pointer)
{
	const auto Root = Roots.find(Pointer);
	if (Root != Roots.end())
	{
		return Root->second;
	}
	const auto Chain = Chains.find(Pointer);
	if (Chain == Chains.end())
	{
		return std::nullopt;
	}
	const std::vector<uint32_t>& Operands = Chain->second->Operands;
	std::optional<FDebugPath> Path = FindPath(Operands[0]);
	size_t Next = 1;
	const auto Variable = Module.VariableIndex.find(Operands[0]);
	if (!Path && Variable != Module.VariableIndex.end() && Operands.size() > 1)
	{
		const FSpirvConstant* const Member = Module.FindConstant(Operands[1]);
		const auto Constant = Constants.find({Variable->second, Member ? uint32_t(Member->Scalars.at(0)) : ~0u});
		if (Constant != Constants.end() && !Constant->second.empty())
		{
			const FSpirvType& Buffer = Module.GetType(Module.Variables[Variable->second].Type);
			Path = FDebugPath{Constant->second, Buffer.Members.at(uint32_t(Member->Scalars[0])).Type};
			Next = 2;
		}
	}
	for (; Path && Next < Operands.size(); ++Next)
	{
		const FSpirvType& Type = Module.GetType(Path->Type);
		const FSpirvConstant* const Index = Module.FindConstant(Operands[Next]);
		const uint32_t Element = Index ? uint32_t(Index->Scalars.at(0)) : 0;
		if (Index)
		{
			Path->Text += Types.ElementOf(Path->Type, Element);
		}
		else
		{
			const std::string Found = Word(Program.WordOf(Operands[Next]));
			const std::string Last = std::to_string(Type.Count - 1);
			const std::string Base = Type.Kind == ESpirvType::Vector ? "(&" + Path->Text + ".x)" : Path->Text;
			Path->Text = Base + "[" + Found + " < " + Last + " ? " + Found + " : " + Last + "]";
		}
		Path->Type = Module.GetMemberType(Path->Type, Type.Kind == ESpirvType::Struct ? Element : 0);
	}
	return Path;
}

/** Without variables of its own: their scope would make a line of two places, at each of which a debugger stops. */
std::string FDebugEmitter::Jump(uint32_t From, uint32_t To)
{
	// All phis of a block read before any of them is written.
	std::string Reads;
	std::string Writes;
	size_t Count = 0;
	const uint32_t Target = Program.BlockOf(To);
	if (Program.Blocks[Target].bCounted)
	{
		Reads = "DrydockTurn(" + std::to_string(Target) + ", " + std::to_string(Program.BlockOf(From)) + "); ";
	}
	for (const FSpirvEdge& Edge : Program.Blocks[Target].Edges)
	{
		for (uint32_t i = 0; Edge.From == From && i < Edge.Size; ++i)
		{
			const std::string Incoming = "DrydockIncoming[" + std::to_string(Count++) + "]";
			Reads += Incoming + " = " + Word(Edge.Source + i) + "; ";
			Writes += Word(Edge.To + i) + " = " + Incoming + "; ";
		}
	}
	NumIncoming = std::max(NumIncoming, Count);
	return "{ " + Reads + Writes + "goto Block" + std::to_string(To) + "; }";
}

std::string FDebugEmitter::MakeSwitch(const FSpirvStep& Step, const FSpirvBlock& Block)
{
	const std::vector<uint32_t>& Operands = Step.I->Operands;
	std::string Text = "switch (" + Word(Arg(Step, 0)) + ") { ";
	for (size_t i = 2; i + 1 < Operands.size(); i += 2)
	{
		Text += "case " + std::to_string(Operands[i]) + "u: " + Jump(Block.Label, Operands[i + 1]) + " ";
	}
	return Text + "default: " + Jump(Block.Label, Operands.at(1)) + " }";
}

std::string FDebugEmitter::MakeReturn(const FSpirvFunction& Function, const FSpirvStep& Step)
{
	std::string Text;
	for (const uint32_t Parameter : Function.Parameters)
	{
		const auto Root = Roots.find(Parameter);
		if (Root != Roots.end())
		{
			Text += Types.CopyToWords(Root->second.Type, Root->second.Text, AtPointer(Program.WordOf(Parameter)));
		}
	}
	const bool bValue = Step.I->Op == OpReturnValue;
	return Text + (bValue ? "return " + Types.ReadWords(GetReturnType(Function), At(Arg(Step, 0))) + ";" : "return;");
}

/** Arguments go through the words, where the interpreter has them; what a debugger shows is passed once more. */
std::string FDebugEmitter::MakeCall(const FSpirvStep& Step)
{
	const FSpirvFunction& Function = Functions[Step.Function];
	const FSpirvProgramFunction& Laid = Program.Functions[Step.Function];
	std::string Before;
	std::string Arguments;
	std::string After;
	for (size_t k = 0; k < Function.Parameters.size(); ++k)
	{
		const uint32_t Words = Laid.Parameters[k];
		const uint32_t TypeId = Module.GetValueTypeId(Function.Parameters[k]);
		const bool bPointer = IsShownPointer(TypeId);
		const uint32_t Type = bPointer ? Module.GetType(TypeId).Element : TypeId;
		Before += CopyWords(Words, Arg(Step, k + 1), Laid.Sizes[k]);
		const std::optional<FDebugPath> Path =
			bPointer ? FindPath(Step.I->Operands[k + 1]) : std::optional<FDebugPath>();
		if (Path)
		{
			Before += Types.CopyToWords(Type, Path->Text, AtPointer(Words));
			After += Types.CopyFromWords(Type, Path->Text, AtPointer(Words));
		}
		if (Types.IsNumeric(Type) && !Types.IsArray(Type) && Module.Names.count(Function.Parameters[k]))
		{
			Arguments +=
				(Arguments.empty() ? "" : ", ") + Types.ReadWords(Type, bPointer ? AtPointer(Words) : At(Words));
		}
	}
	const FNamed& Callee = Named[Function.Id];
	const std::string Call = "::" + Callee.Name + "(" + Arguments + "); ";
	const uint32_t Type = GetReturnType(Function);
	const std::string Value = Type && Types.IsArray(Type) ? Callee.Result + ".Value" : Callee.Result;
	return Before + (Type ? Callee.Result + " = " + Call + Types.CopyToWords(Type, Value, At(Step.To)) : Call) + After;
}

std::string FDebugEmitter::MakeStatement(const FSpirvFunction& Function, const FSpirvBlock& Block, uint32_t StepIndex)
{
	const FSpirvStep& Step = Program.Steps[StepIndex];
	const FSpirvInstruction& I = *Step.I;
	std::string Do = "DrydockDo(" + std::to_string(StepIndex) + ");";
	switch (I.Op)
	{
	case OpLoad:
		if (const std::optional<FDebugPath> Path = FindPath(I.Operands[0]))
		{
			return Types.CopyToWords(Path->Type, Path->Text, At(Step.To));
		}
		return Do;
	case OpStore:
		if (const std::optional<FDebugPath> Path = FindPath(I.Operands[0]))
		{
			return Types.CopyFromWords(Path->Type, Path->Text, At(Arg(Step, 1)));
		}
		return Do;
	case OpExtInst:
		if (I.Operands[1] == ExtModf)
		{
			const std::optional<FDebugPath> Path = FindPath(I.Operands.at(3));
			return Path ? Do + " " + Types.CopyFromWords(Path->Type, Path->Text, AtPointer(Arg(Step, 3))) : Do;
		}
		return Do;
	case OpFunctionCall:
		return Step.Function == ~0u ? Do : MakeCall(Step);
	case OpBranch:
		return Jump(Block.Label, I.Operands[0]);
	case OpBranchConditional:
		return "if (" + Word(Arg(Step, 0)) + ") " + Jump(Block.Label, I.Operands[1]) + " else " +
			   Jump(Block.Label, I.Operands[2]);
	case OpSwitch:
		return MakeSwitch(Step, Block);
	case OpReturn:
	case OpReturnValue:
		return MakeReturn(Function, Step);
	default:
		return Do;
	}
}

} // namespace Drydock
