// Finds where variables begin and end by who names them: SPIR-V puts all at a function's beginning.
#include "DebugFunction.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

bool Cross(const FDebugLocal& A, const FDebugLocal& B)
{
	return A.First < B.First && B.First <= A.Last && A.Last < B.Last;
}

bool Overlap(const FDebugLocal& A, const FDebugLocal& B)
{
	return A.First <= B.Last && B.First <= A.Last;
}

using FLine = std::pair<uint32_t, int>; // file and line

/** Code of one line stays on one side of a brace: a debugger would stop twice at it. */
void TakeWholeLines(const std::vector<FLine>& Lines, std::vector<FDebugLocal>& Locals)
{
	for (FDebugLocal& Local : Locals)
	{
		while (Local.First > 0 && Lines[Local.First - 1] == Lines[Local.First])
		{
			--Local.First;
		}
		while (Local.Last + 1 < Lines.size() && Lines[Local.Last + 1] == Lines[Local.Last])
		{
			++Local.Last;
		}
	}
}

/** Braces lie inside each other or beside each other. */
void MakeNested(std::vector<FDebugLocal>& Locals)
{
	for (bool bChanged = true; bChanged;)
	{
		bChanged = false;
		for (FDebugLocal& A : Locals)
		{
			for (FDebugLocal& B : Locals)
			{
				if (A.bScoped && B.bScoped && Cross(A, B))
				{
					A.Last = B.Last;
					B.First = A.First;
					bChanged = true;
				}
			}
		}
	}
}

/** A variable that a debugger shows: numbers, in a function, named by the author. */
bool IsShown(const FSpirvProgram& Program, size_t Variable)
{
	const FSpirvVariable& Found = Program.Module.Variables[Variable];
	return Found.Storage == StorageFunction && Program.Module.GetType(Found.Type).NumScalars > 0 &&
		   !IsHiddenVariable(Program, Variable);
}

void AddUse(const FSpirvModule& Module, uint32_t Variable, size_t Position, std::vector<FDebugLocal>& Locals)
{
	const auto Known = std::ranges::find(Locals, Variable, &FDebugLocal::Variable);
	if (Known != Locals.end())
	{
		Known->Last = Position;
		return;
	}
	Locals.push_back({Variable, MakeCppName(Module.Variables[Variable].Name), Position, Position, false});
}

bool ClashesWithEarlier(const std::vector<FDebugLocal>& Locals, size_t Index)
{
	const FDebugLocal& Local = Locals[Index];
	return std::any_of(Locals.begin(), Locals.begin() + std::ptrdiff_t(Index),
		[&Local](const FDebugLocal& Earlier)
		{
			const bool bApart = Local.bScoped && Earlier.bScoped && !Overlap(Local, Earlier);
			return Earlier.Name == Local.Name && !bApart;
		});
}

} // namespace

bool IsHiddenVariable(const FSpirvProgram& Program, size_t Variable)
{
	return Program.VariableNames[Variable].empty() ||
		   Program.VariableNames[Variable] != Program.Module.Variables[Variable].Name;
}

std::vector<uint32_t> GetPointerOperands(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpLoad:
	case OpStore:
	case OpAccessChain:
	case OpInBoundsAccessChain:
		return {I.Operands.at(0)};
	case OpFunctionCall:
		return {I.Operands.begin() + 1, I.Operands.end()};
	case OpExtInst:
		return I.Operands.at(1) == ExtModf ? std::vector<uint32_t>{I.Operands.at(3)} : std::vector<uint32_t>();
	default:
		return {};
	}
}

std::vector<FDebugLocal> FindDebugLocals(
	const FSpirvProgram& Program, const FSpirvFunction& Function, const std::set<std::string>& TakenNames)
{
	const FSpirvModule& Module = Program.Module;
	std::vector<FDebugLocal> Locals;
	std::map<uint32_t, uint32_t> Bases; // of access chains
	std::vector<FLine> Lines;           // of the instructions
	for (uint32_t Block = Function.FirstBlock; Block < Function.FirstBlock + Function.NumBlocks; ++Block)
	{
		for (const FSpirvInstruction& I : Module.Blocks[Block].Instructions)
		{
			for (const uint32_t Pointer : GetPointerOperands(I))
			{
				const auto Base = Bases.find(Pointer);
				const uint32_t Id = Base == Bases.end() ? Pointer : Base->second;
				if (I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain)
				{
					Bases[I.Result] = Id;
				}
				const auto Found = Module.VariableIndex.find(Id);
				if (Found != Module.VariableIndex.end() && IsShown(Program, Found->second))
				{
					AddUse(Module, Found->second, Lines.size(), Locals);
				}
			}
			Lines.emplace_back(I.File, I.Line);
		}
	}
	for (FDebugLocal& Local : Locals)
	{
		Local.bScoped = std::ranges::any_of(
			Locals, [&Local](const FDebugLocal& Other) { return &Other != &Local && Other.Name == Local.Name; });
	}
	TakeWholeLines(Lines, Locals);
	MakeNested(Locals);
	for (size_t i = 0; i < Locals.size(); ++i)
	{
		const std::string Name = Locals[i].Name;
		for (int Number = 2; TakenNames.count(Locals[i].Name) || ClashesWithEarlier(Locals, i); ++Number)
		{
			Locals[i].Name = Name + "_" + std::to_string(Number);
		}
	}
	return Locals;
}

} // namespace Drydock
