// Holds a vertex shader that is ready to run, one vertex after the other: its inputs from a draw, and its outputs.
// Draws of post-processing have three to six vertices, so nothing is compiled to machine code for them.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"

#include <cstdint>

namespace Drydock
{

/** Attributes of a vertex declaration, and TEXCOORDs of a vertex shader. */
constexpr int32_t GMaxVertexAttributes = 16;
constexpr int32_t GMaxTexCoords = 16;

/** The inputs that a vertex shader reads besides its parameters. */
struct FVertexInput
{
	uint32_t VertexId = 0;
	uint32_t InstanceId = 0;
	double Attributes[GMaxVertexAttributes][4] = {}; // by the n of ATTRIBUTEn
};

/** The outputs that a vertex shader writes. */
struct FVertexOutput
{
	float Position[4] = {};                 // SV_POSITION, clip space
	float TexCoords[GMaxTexCoords][4] = {}; // by the n of TEXCOORDn; 0 where it writes none
};

class DRYDOCK_API FVertexProgram
{
public:
	virtual ~FVertexProgram();

	/** Runs one vertex. Args: as of a pixel shader, without targets and interpolants. Thread-safe. */
	virtual FVertexOutput Run(const FKernelArgs& Args, const FVertexInput& Input) const = 0;

	/** Bit n: it reads ATTRIBUTEn. */
	virtual uint32_t GetAttributesRead() const = 0;
	/** Bit n: it writes TEXCOORDn. */
	virtual uint32_t GetTexCoordsWritten() const = 0;
};

} // namespace Drydock
