// The hidden counters of structured buffers: of Append, Consume, IncrementCounter and DecrementCounter. To every later
// stage such a counter is a structured buffer of one uint, and what changes it an atomic operation like others.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** Sets FSpirvVariable::CounterOf and gives these variables the type of a RWStructuredBuffer<uint>. Front ends declare
 * them as a block of one integer, and name its buffer by a decoration (SPV_GOOGLE_hlsl_functionality1), as "X@count"
 * (glslang) or as "counter.var.X" (DXC). */
void MakeCountersBuffers(FSpirvModule& Module);

} // namespace Drydock
