// Matches parameters in C++ by name and type with what the compiled shader reads, once per shader permutation and
// struct; each pass then only copies. A mismatch is an error that names both sides.
#pragma once

#include "BoundShader.h"
#include "CoreMinimal.h"
#include "Diagnostics.h"
#include "Shader.h"

#include <vector>

namespace Drydock
{

struct FShaderBindingPlan;

/** Fills Out from Parameters, inside a pass. Throws FError with every mismatch between shader and struct, or with every
 * resource and uniform buffer that the shader reads and that is null (DD2015). */
DRYDOCK_API void BindShaderParameters(
	const FShaderRef& Shader, const FShaderParametersMetadata& Metadata, const void* Parameters, FBoundShader& Out);

/** The same with the shader's own FParameters. */
DRYDOCK_API void BindShaderParameters(const FShaderRef& Shader, const void* Parameters, FBoundShader& Out);

/** Every mismatch between what the shader reads and what the struct offers; empty when all fits. Resources are not
 * looked at. */
DRYDOCK_API std::vector<FDiagnostic> MatchShaderParameters(
	const std::string& ShaderName, const FShaderReflection& Reflection, const FShaderParametersMetadata& Metadata);

/** Packs the constants and takes views of the resources. A resource or buffer that is read and null is DD2015. */
DRYDOCK_API void FollowShaderBindingPlan(
	const FShaderBindingPlan& Plan, const FShaderReflection& Reflection, const void* Parameters, FBoundShader& Out);

/** A binding whose constants are 0 and whose resources are to be set. */
DRYDOCK_API FBoundShader BindToBeSet(FShader& Shader);

/** The parameters, as a compiled graph names them, through which the shader uses resources, of all structs that were
 * bound to it so far. Empty where none was. */
DRYDOCK_API std::vector<std::string> ListBoundResources(FShader& Shader);

/** False for the engine's vertex shader of screen passes, whose rectangle draws know without running it. */
inline bool IsRun(const FShaderRef& Shader)
{
	return Shader->GetFrequency() != SF_Vertex || Shader.GetType()->IsRunByDraws();
}

/** Throws DD2015, in the engine's words, unless every resource and uniform buffer that the shader reads is set in
 * Parameters. */
DRYDOCK_API void RequireShaderParameters(
	const FShaderRef& Shader, const FShaderParametersMetadata& Metadata, const void* Parameters);

} // namespace Drydock
