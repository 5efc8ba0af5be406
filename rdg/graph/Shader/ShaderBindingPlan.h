// Holds the result of matching a shader with a parameter struct: the destinations of bytes and resources. Made once,
// followed by every pass. Used by this folder and its tests.
#pragma once

#include "BoundShader.h"
#include "Diagnostics.h"
#include "ShaderParameterMetadata.h"
#include "ShaderReflection.h"
#include "ShaderTypeNames.h"
#include "StaticSamplers.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Codes of messages. */
enum EBindingError
{
	MissingParameter = 6101,
	ParameterType = 6102,
	ParameterArray = 6103,
	MissingResource = 6104,
	ResourceType = 6105,
	MissingUniformBuffer = 6106,
};

/** Source of values: the parameter struct itself (source 0) or a uniform buffer that one of its members refers to. */
struct FBindingSource
{
	const FShaderParametersMetadata* Metadata = nullptr;
	EUniformBufferBaseType BaseType =
		UBMT_INVALID;    // how the member refers to the buffer; UBMT_INVALID: the struct itself
	uint32_t Offset = 0; // of that member
	std::string CodeName;
	bool bUsed = false;    // something the shader reads comes from here
	bool bOfFrame = false; // no member refers to it: FFrameUniformBufferScope
};

/** Copies Size bytes of a source to a constant buffer. */
struct FConstantCopy
{
	uint32_t Source;
	uint32_t SourceOffset;
	uint32_t Buffer;
	uint32_t Offset;
	uint32_t Size;
};

/** Puts the resource at an offset of a source into a slot. */
struct FResourceCopy
{
	EResourceList List;
	uint32_t Slot;
	uint32_t Source;
	uint32_t SourceOffset;
	EUniformBufferBaseType BaseType;
	std::string CodeName;
};

/** Puts a sampler that no member gives into a slot. */
struct FStaticSamplerCopy
{
	uint32_t Slot;
	FRHISamplerState* Sampler;
};

struct FShaderBindingPlan
{
	std::vector<FBindingSource> Sources;
	std::vector<FConstantCopy> Constants;
	std::vector<FResourceCopy> Resources;
	std::vector<FStaticSamplerCopy> StaticSamplers;
};

/** A vertex shader's uniform buffer of that HLSL name that no parameter struct holds: each draw brings its own. */
DRYDOCK_API bool IsBoundByDraw(const FShaderReflection& Reflection, const std::string& UniformBuffer);

/** Appends a message for each thing that the shader reads and the struct does not offer in that type. */
DRYDOCK_API FShaderBindingPlan MakeShaderBindingPlan(const std::string& ShaderName, const FShaderReflection& Reflection,
	const FShaderParametersMetadata& Metadata, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
