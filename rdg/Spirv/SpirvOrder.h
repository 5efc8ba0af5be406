// The order in which threads of a group come by: which of two that wait at different places has to go on first, so that
// they meet again.
#pragma once

#include "SpirvStructure.h"

namespace Drydock
{

/** Of each block, by its index in the module. */
struct FSpirvOrder
{
	std::vector<uint32_t> Places;             // in the text: what comes later has the higher number
	std::vector<std::vector<uint32_t>> Loops; // blocks of the headers of the loops around it, outermost first
};

DRYDOCK_API FSpirvOrder FindOrder(const FSpirvModule& Module, const FSpirvStructure& Structure);

} // namespace Drydock
