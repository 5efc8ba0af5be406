// A shader's parameters as its SPIR-V declares them, and the slots that a kernel reads them from.
#pragma once

#include "ShaderReflection.h"
#include "SpirvStructure.h"

#include <map>

namespace Drydock
{

struct FSpirvReflection
{
	FShaderReflection Reflection;
	std::map<uint32_t, uint32_t> Slots; // variable id -> index in its list of the reflection
	uint32_t AttributesRead = 0;        // vertex: bit n for ATTRIBUTEn
	uint32_t TexCoordsWritten = 0;      // vertex: bit n for the interpolant n
};

/** Source is the flattened HLSL: SPIR-V does not tell a ByteAddressBuffer from a StructuredBuffer<uint>. Throws
 *  FSpirvError for inputs and outputs that no pass of a CPU frame has. */
DRYDOCK_API FSpirvReflection ReflectSpirv(
	const FSpirvModule& Module, const FSpirvStructure& Structure, const std::string& Source);

/** Texture samples and loads that every thread makes; -1 when that depends on the thread or on parameters. */
int32_t CountStaticSamples(const FSpirvModule& Module, const FSpirvStructure& Structure);

/** 7 of "TEXCOORD7" where Prefix is "TEXCOORD", 0 without a number; -1 when Semantic is another one or above 15. */
int32_t GetSemanticIndex(const std::string& Semantic, const std::string& Prefix);

/** In capital letters and with its number, to which More is added. */
std::string NormaliseSemantic(const std::string& Semantic, int32_t More);

/** The place of a variable among the interpolants, by its semantic; that of its first element where it is an array.
 * Semantics that are neither TEXCOORD0 to 15 nor COLOR0 to 3 have places from GFirstNamedInterpolant on, by their
 * locations: a module without its unused inputs gives the same places. -1 for other variables and those too far behind.
 */
int32_t GetInterpolantIndex(const FSpirvVariable& Variable);

} // namespace Drydock
