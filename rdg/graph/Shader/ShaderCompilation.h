// Gives the compiled code and the reflection of a shader class's permutation: makes the compiler's request, keeps
// results between passes, and drops both.
#pragma once

#include "CoreMinimal.h"
#include "Shader.h"
#include "ShaderCompileRequest.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

/** Arithmetic of the shaders from now on, from r.Drydock.Precision and r.Drydock.LaneWidth. */
DRYDOCK_API FLaneConfig GetShaderLaneConfig();

/** The compiler's request for a permutation: file, entry, stage, defines, uniform buffers named by Metadata. */
DRYDOCK_API FShaderCompileRequest MakeShaderCompileRequest(
	const FShaderRef& Shader, const FShaderParametersMetadata* Metadata);

/** The same for a shader that no class names: every registered uniform buffer, no defines of a class. */
DRYDOCK_API FShaderCompileRequest MakeShaderCompileRequest(
	const std::string& VirtualPath, const std::string& EntryPoint, EShaderStage Stage);

/** During its scope Function receives each request before the compiler does; from any thread, one call at a time. There
 * can be one listener at a time. */
class DRYDOCK_API FScopedCompileListener : private FNoncopyable
{
public:
	explicit FScopedCompileListener(std::function<void(const FShaderCompileRequest&)> Function);
	~FScopedCompileListener();
};

/** Compiled code for the current arithmetic; compiles, or takes from the cache. bQuads: as in FShaderCompileRequest.
 * Throws FError with the compiler's messages. */
DRYDOCK_API std::shared_ptr<const FCompiledShader> GetCompiledShader(const FShaderRef& Shader, bool bQuads = false);

/** The parameters that the shader reads; compiled code is not needed for this. Throws FError with the compiler's
 * messages. */
DRYDOCK_API std::shared_ptr<const FShaderReflection> GetShaderReflection(const FShaderRef& Shader);

/** Names the text of the shader as it is now (FingerprintShader). Throws FError with the messages about its files. */
DRYDOCK_API std::string GetShaderFingerprint(const FShaderRef& Shader);

/** Compiles a list of permutations, several at a time (0: one per core). Throws FError with the messages of all that
 * failed. */
DRYDOCK_API void WarmShaders(const std::vector<FShaderRef>& Shaders, int32 NumThreads = 0);

/** Forgets compiled code, reflections and copy plans, so that edited files are read again. No pass may be running. */
DRYDOCK_API void ForgetShaders();

/** The same for the shaders that have read one of these files. */
DRYDOCK_API void ForgetShadersOf(const std::vector<std::string>& Files);

} // namespace Drydock
