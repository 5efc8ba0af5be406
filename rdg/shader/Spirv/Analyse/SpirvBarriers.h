// Finds barriers that threads of a group may miss, by the flow around them.
#pragma once

#include "SpirvUniformity.h"

#include <vector>

namespace Drydock
{

struct FDivergentBarrier
{
	const FSpirvInstruction* Barrier = nullptr;
	const FSpirvInstruction* Parting = nullptr; // the branch after which some threads may be elsewhere
};

/** Each barrier with GroupSync that stands in a branch or loop which is not known to be the same for the group, or
 * behind one that some threads may have left by return, break or continue. */
std::vector<FDivergentBarrier> FindDivergentBarriers(
	const FSpirvModule& Module, const FSpirvStructure& Structure, const FSpirvUniformity& Uniformity);

} // namespace Drydock
