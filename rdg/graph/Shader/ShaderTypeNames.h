// Names the types of a shader in HLSL, and finds which members of a parameter struct fit them.
#pragma once

#include "ShaderParameterMetadata.h"
#include "ShaderReflection.h"

#include <cstdint>
#include <string>

namespace Drydock
{

/** The lists of a shader's reflection. */
enum class EResourceList : uint8_t
{
	Textures,
	RWTextures,
	Samplers,
	Buffers,
	RWBuffers,
};

/** "float", "uint64_t" */
const char* GetScalarName(EShaderScalar Scalar);

int GetBits(EShaderScalar Scalar);

/** Bits of the elements in "StructuredBuffer<int64_t2>"; 0 where they are not plain numbers, or could be of any width.
 */
int GetElementBits(const std::string& MacroText);

/** "float4[3]"; 0 elements: no array. */
std::string WithElements(const std::string& Type, uint32_t NumElements);

/** "float3", "int4x4[2]" */
std::string GetTypeName(const FShaderConstant& Constant);

/** "RWTexture2D": without what is in <>. */
std::string GetTypeName(EResourceList List, const FShaderResource& Resource);

/** Whether a macro of this kind binds a resource of the list. */
bool Accepts(EResourceList List, EUniformBufferBaseType BaseType);

/** "RWTexture2D<float4>" and "RWTexture2D" name the same kind; text that names no known kind fits everything. */
bool TypeTextAgrees(const std::string& MacroText, const std::string& HlslType);

} // namespace Drydock
