// The second half of reading SPIR-V, defined by SpirvChecker.cpp: do ids, types and operand counts fit together?
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** Throws FSpirvError at the first instruction that does not fit, or that the CPU tier refuses. */
void CheckSpirv(const FSpirvModule& Module);

} // namespace Drydock
