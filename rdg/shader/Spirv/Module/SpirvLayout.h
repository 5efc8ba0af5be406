// Gives buffer members their offsets and strides, by Direct3D's rules.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** Replaces the offsets and strides that the module came with: constant buffers in registers of 16 bytes that no vector
 *  crosses, structured buffers without any padding. */
void ApplyD3DLayout(FSpirvModule& Module);

} // namespace Drydock
