// Runs a shader's SPIR-V one thread at a time, in float. Slow, and needs no compiler: vertex shaders run by it, and it
// is the model that compiled kernels are tested against, for it knows nothing of lanes, masks, structure or uniformity.
#pragma once

#include "ShaderKernel.h"
#include "SpirvGroups.h"
#include "SpirvReflect.h"
#include "VertexProgram.h"

#include <memory>

namespace Drydock
{

/** The values that one thread wrote to its render targets. */
struct FInterpretedPixel
{
	bool bDiscarded = false;
	float Targets[GDepthTarget + 1][4] = {}; // integers: their bits; the depth in 0..1
};

class FSpirvInterpreterImpl;

class DRYDOCK_API FSpirvInterpreter
{
public:
	/** Module and Reflection must outlive it. WaveSize: of shaders whose threads work together. */
	FSpirvInterpreter(
		const FSpirvModule& Module, const FSpirvReflection& Reflection, uint32_t WaveSize = GDefaultWaveSize);
	~FSpirvInterpreter();

	/** Runs the thread of pixel or dispatch id (X, Y, Z); of a shader that runs by quads with the others of its quad,
	 *  which write nothing. UAVs are written; render targets are returned, not written.
	 *  Throws FSpirvError when the shader does not end within MaxSteps instructions or does what it must not. */
	FInterpretedPixel Run(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps = 10'000'000);

	/** Runs the group of SV_GroupID of a compute shader whose threads work together; throws as Run does. */
	void RunGroup(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps = 10'000'000);

	/** Runs a vertex shader for one vertex; throws as Run does. */
	FVertexOutput RunVertex(const FKernelArgs& Args, const FVertexInput& Input, uint64_t MaxSteps = 10'000'000);

private:
	std::unique_ptr<FSpirvInterpreterImpl> Impl;
};

/** The vertex shader of a module. */
DRYDOCK_API std::shared_ptr<const FVertexProgram> MakeVertexProgram(FSpirvModule Module, FSpirvReflection Reflection);

} // namespace Drydock
