// A shader's SPIR-V as C++ over lanes: the text of one kernel, the same for float and double and for every lane count
// (macros DRYDOCK_REAL and DRYDOCK_LANES). SpirvEmitter.cpp defines it.
#pragma once

#include "SpirvGroups.h"
#include "SpirvReflect.h"
#include "SpirvUniformity.h"

namespace Drydock
{

struct FSpirvEmitInput
{
	const FSpirvModule& Module;
	const FSpirvStructure& Structure;
	const FSpirvUniformity& Uniformity;
	const FSpirvReflection& Reflection;
	uint32_t WaveSize = GDefaultWaveSize;
};

/** Throws FSpirvError for what the CPU tier does not do. */
DRYDOCK_API std::string EmitKernel(const FSpirvEmitInput& Input, const std::string& Title);

} // namespace Drydock
