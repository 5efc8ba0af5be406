// Holds a vertex shader that is ready to run, one vertex after the other: its inputs from a draw, and its outputs.
// Draws of post-processing have three to six vertices, so nothing is compiled to machine code for them.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Attributes of a vertex declaration, and TEXCOORDs of a vertex shader. */
constexpr int32_t GMaxVertexAttributes = 16;
constexpr int32_t GMaxTexCoords = 16;
/** The first interpolant that is neither TEXCOORD0 to 15 nor, behind these, COLOR0 to 3: see
 * FShaderReflection::NamedInterpolants. */
constexpr int32_t GFirstNamedInterpolant = GMaxTexCoords + 4;
/** Outputs of a vertex shader beside the position. */
constexpr int32_t GMaxInterpolants = 32;

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
	float Position[4] = {};                     // SV_POSITION, clip space
	double TexCoords[GMaxInterpolants][4] = {}; // floats and integers; 0 where it writes none
};

class DRYDOCK_API FVertexProgram
{
public:
	virtual ~FVertexProgram();

	/** Runs one vertex. Args: as of a pixel shader, without targets and interpolants. Thread-safe. */
	virtual FVertexOutput Run(const FKernelArgs& Args, const FVertexInput& Input) const = 0;

	/** Bit n: it reads ATTRIBUTEn. */
	virtual uint32_t GetAttributesRead() const = 0;
	/** Bit n: it writes the interpolant n. */
	virtual uint32_t GetTexCoordsWritten() const = 0;
};

/** "TEXCOORD3", "COLOR0" or one of Named, by the place among the interpolants. Named: those of the shader's reflection.
 */
inline std::string GetInterpolantName(int32_t Index, const std::vector<std::string>& Named)
{
	if (Index >= GFirstNamedInterpolant)
	{
		return Named.at(size_t(Index - GFirstNamedInterpolant));
	}
	const bool bColor = Index >= GMaxTexCoords;
	return (bColor ? "COLOR" : "TEXCOORD") + std::to_string(bColor ? Index - GMaxTexCoords : Index);
}

} // namespace Drydock
