// The model of the shader tier: runs a shader's SPIR-V one thread at a time, block after block, as the specification
// says, in float. It knows nothing of lanes, masks, structure or uniformity; compiled kernels are tested against it.
// Slow, and needs no compiler.
#pragma once

#include "ShaderKernel.h"
#include "SpirvReflect.h"

#include <memory>

namespace Drydock
{

/** What one thread wrote to its render targets. */
struct FInterpretedPixel
{
	bool bDiscarded = false;
	float Targets[8][4] = {};
};

class FSpirvInterpreterImpl;

class DRYDOCK_API FSpirvInterpreter
{
public:
	/** Module and Reflection must outlive it. */
	FSpirvInterpreter(const FSpirvModule& Module, const FSpirvReflection& Reflection);
	~FSpirvInterpreter();

	/** Runs the thread of pixel or dispatch id (X, Y, Z). UAVs are written; render targets are returned, not written.
	 *  Throws FSpirvError when the shader does not end within MaxSteps instructions or does what it must not. */
	FInterpretedPixel Run(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps = 10'000'000);

private:
	std::unique_ptr<FSpirvInterpreterImpl> Impl;
};

} // namespace Drydock
