// Orders the threads of a group: which of two threads that wait at different places has to go on first, so that they
// meet again.
#pragma once

#include "SpirvStructure.h"

namespace Drydock
{

/** The order of blocks, by the block's index in the module. */
struct FSpirvOrder
{
	std::vector<uint32_t> Places;             // in the text: what comes later has the higher number
	std::vector<std::vector<uint32_t>> Loops; // blocks of the headers of the loops around it, outermost first
};

/** Finds the order of all functions of the module, each for itself. Throws FSpirvError when control flow is not
 * structured. */
DRYDOCK_API FSpirvOrder FindOrder(const FSpirvModule& Module);

} // namespace Drydock
