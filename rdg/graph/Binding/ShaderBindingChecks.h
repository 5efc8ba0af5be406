// Checks before a pass that its parameters are set and fit what the shader reads of them.
#pragma once

#include "BoundShader.h"
#include "ShaderBindingPlan.h"

#include <string>

namespace Drydock
{

/** Throws FError (exit code 2), in the engine's words, one message for each uniform buffer and resource that the shader
 * reads and that is not there. */
void CheckRequiredParameters(const FShaderBindingPlan& Plan, const std::string& ShaderName, const void* Parameters);

/** Throws FError (exit code 2) where a shader reads a cube and no cube is bound, or the other way, where it compares by
 * a sampler that has nothing to compare by, and where it counts by a view without a counter. A view of a cube may be
 * read as its faces. */
void CheckBoundKinds(const FShaderBindingPlan& Plan, const FShaderReflection& Reflection, const std::string& ShaderName,
	const void* Parameters);

/** Throws FError (exit code 2) where a structured buffer's elements have another size than the shader's. */
void CheckStrides(const FShaderBindingPlan& Plan, const FBoundShader& Bound, const void* Parameters);

/** Notes, by ReportRDGWarning, where a shader stores more components than the texture keeps. Such a store may be a
 * mistake: three-component formats are stored to as float4 everywhere, those of one or two seldom on purpose. */
void ReportDroppedComponents(const FShaderBindingPlan& Plan, const FShaderReflection& Reflection,
	const std::string& ShaderName, const void* Parameters);

} // namespace Drydock
