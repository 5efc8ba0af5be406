// Binding: parameters in C++ are matched by name and type with what the compiled shader reads, once per shader
// permutation and struct; each pass then only copies. What does not match is an error that names both sides.
// Source: drydock.
#pragma once

#include "BoundShader.h"
#include "CoreMinimal.h"
#include "Diagnostics.h"
#include "Shader.h"

#include <vector>

namespace Drydock
{

/** Arithmetic of the shaders from now on, from r.Drydock.Precision and r.Drydock.LaneWidth. */
DRYDOCK_API FLaneConfig GetShaderLaneConfig();

/** What the compiler is asked for a permutation: file, entry, stage, defines, uniform buffers named by Metadata. */
DRYDOCK_API FShaderCompileRequest MakeShaderCompileRequest(
	const FShaderRef& Shader, const FShaderParametersMetadata* Metadata);

/** Compiled code for the current arithmetic; compiles, or takes from the cache. Throws FError with the compiler's
 * messages. */
DRYDOCK_API std::shared_ptr<const FCompiledShader> GetCompiledShader(const FShaderRef& Shader);

/** What the shader reads; compiled code is not needed for it. Throws FError with the compiler's messages. */
DRYDOCK_API std::shared_ptr<const FShaderReflection> GetShaderReflection(const FShaderRef& Shader);

/** Fills Out from Parameters, inside a pass. Throws FError with every mismatch between shader and struct. A resource or
 * uniform buffer that the shader reads and that is null is a check. */
DRYDOCK_API void BindShaderParameters(
	const FShaderRef& Shader, const FShaderParametersMetadata& Metadata, const void* Parameters, FBoundShader& Out);

/** The same with the shader's own FParameters. */
DRYDOCK_API void BindShaderParameters(const FShaderRef& Shader, const void* Parameters, FBoundShader& Out);

/** Every mismatch between what the shader reads and what the struct offers; empty when all fits. Resources are not
 * looked at. */
DRYDOCK_API std::vector<FDiagnostic> MatchShaderParameters(
	const std::string& ShaderName, const FShaderReflection& Reflection, const FShaderParametersMetadata& Metadata);

/** Compiles a list of permutations, several at a time (0: one per core). Throws FError with the messages of all that
 * failed. */
DRYDOCK_API void WarmShaders(const std::vector<FShaderRef>& Shaders, int32 NumThreads = 0);

/** Forgets compiled code, reflections and copy plans, so that edited files are read again. No pass may be running. */
DRYDOCK_API void ForgetShaders();

} // namespace Drydock
