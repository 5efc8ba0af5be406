// Writes down what a thread does while the interpreter runs it.
#pragma once

#include "InspectedShader.h"
#include "PixelTrace.h"

namespace Drydock
{

/** Runs one thread and records its steps. Args are read and, where the shader writes to textures and buffers, written:
 * give it a sandbox (Sandbox.h). bDouble: in double. Throws FSpirvError where the shader does not end. */
DRYDOCK_API FPixelTrace TracePixel(
	FInspectedShader& Shader, const FKernelArgs& Args, const int32_t (&Position)[3], bool bDouble, uint64_t MaxSteps);

} // namespace Drydock
