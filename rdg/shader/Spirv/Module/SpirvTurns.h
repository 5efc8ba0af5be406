// Finds how often a loop runs, where its text determines it. Used to count taps, and to end loops that do not end.
#pragma once

#include "SpirvModule.h"

#include <optional>

namespace Drydock
{

/** Finds the turns of a module's loops; the module must outlive it. */
class FSpirvTurns
{
public:
	explicit FSpirvTurns(const FSpirvModule& InModule);

	/** Turns of the loop with this header, if nothing but its condition ends it: from one constant to another by a
	 * third, up to 2^20 of them. Nothing: not known. */
	std::optional<int64_t> Find(uint32_t Header) const;

private:
	const FSpirvModule& Module;
	std::unordered_map<uint32_t, const FSpirvInstruction*> Definitions;
};

} // namespace Drydock
