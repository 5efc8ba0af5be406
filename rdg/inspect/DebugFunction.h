// Chooses the variables of a function that a debugger shows, with their names and the braces they stand in.
#pragma once

#include "DebugTypes.h"
#include "SpirvProgram.h"

namespace Drydock
{

/** A variable of the author's inside a function. */
struct FDebugLocal
{
	uint32_t Variable = 0; // into the module's variables
	std::string Name;
	size_t First = 0; // of the function's instructions that name it, counted from 0
	size_t Last = 0;
	bool bScoped = false; // there is another of that name: braces around First to Last
};

/** In the order in which they are first used. */
DRYDOCK_API std::vector<FDebugLocal> FindDebugLocals(
	const FSpirvProgram& Program, const FSpirvFunction& Function, const std::set<std::string>& TakenNames);

/** Operands that point to memory. */
std::vector<uint32_t> GetPointerOperands(const FSpirvInstruction& I);

/** The front end's copies and the like, which no author named. */
bool IsHiddenVariable(const FSpirvProgram& Program, size_t Variable);

} // namespace Drydock
