// Follows pointers back to what declared them.
#include "AuthorsNames.h"

namespace Drydock
{

using namespace Spirv;

std::vector<bool> FindAuthorsBlocks(const FSpirvModule& Module)
{
	std::vector<bool> bAuthors(Module.Blocks.size(), true);
	for (const FSpirvFunction& Function : Module.Functions)
	{
		for (uint32_t Block = 0; Block < Function.NumBlocks && Function.Name.empty(); ++Block)
		{
			bAuthors[Function.FirstBlock + Block] = false;
		}
	}
	return bAuthors;
}

FAuthorsNames::FAuthorsNames(const FSpirvProgram& InProgram)
	: Program(InProgram)
{
	for (const FSpirvStep& Step : Program.Steps)
	{
		if (Step.I->Op == OpAccessChain || Step.I->Op == OpInBoundsAccessChain)
		{
			const auto Known = Bases.find(Step.I->Operands[0]);
			Bases[Step.I->Result] = Known == Bases.end() ? Step.I->Operands[0] : Known->second;
		}
	}
}

std::optional<FNamedVariable> FAuthorsNames::Find(uint32_t Pointer) const
{
	const FSpirvModule& Module = Program.Module;
	const auto Chain = Bases.find(Pointer);
	const uint32_t Base = Chain == Bases.end() ? Pointer : Chain->second;
	FNamedVariable Found;
	const auto Variable = Module.VariableIndex.find(Base);
	if (Variable != Module.VariableIndex.end())
	{
		Found = {Program.VariableNames[Variable->second], Module.Variables[Variable->second].Type};
	}
	else
	{
		const auto Parameter = Module.Names.find(Base);
		const FSpirvType* const Type = Parameter == Module.Names.end() ? nullptr : &Module.GetValueType(Base);
		if (Type && Type->Kind == ESpirvType::Pointer)
		{
			Found = {Parameter->second, Type->Element};
		}
	}
	const bool bNumeric = !Found.Name.empty() && Module.GetType(Found.Type).NumScalars != 0;
	return bNumeric ? std::optional<FNamedVariable>(std::move(Found)) : std::nullopt;
}

uint32_t FAuthorsNames::FindWords(const FSpirvThreadView& Thread, uint32_t PointerWord) const
{
	const uint32_t At = Thread.GetBits(PointerWord);
	for (const FSpirvMemory& Memory : Program.Memory)
	{
		if (At >= Memory.First && At < Memory.First + Memory.Size)
		{
			return Memory.First;
		}
	}
	return GNoSpirvWord;
}

} // namespace Drydock
