// Compiles a .usf entry point to a function that runs over tiles: flatten includes, the front end (HLSL to SPIR-V),
// reflection, SPIR-V to C++ over lanes, the system compiler, a content-hashed cache. A vertex shader stays SPIR-V.
#pragma once

#include "DrydockAPI.h"
#include "ShaderCompileRequest.h"
#include "ShaderDirectories.h"
#include "ShaderTier.h"

#include <memory>
#include <string>

namespace Drydock
{

/** Compiles, or takes from memory or the cache. Thread-safe. Throws FError (code DD6xxx, exit code 2) with every
 * message the front end gave, each as "X.usf:LINE: error: ...". */
DRYDOCK_API std::shared_ptr<const FCompiledShader> CompileShader(const FShaderCompileRequest& Request);

/** Front end only: flatten, HLSL and reflection, no C++ compiler. For graphs that are compiled but not run. */
DRYDOCK_API FShaderReflection ReflectShader(const FShaderCompileRequest& Request);

/** Names the text of a shader: the file and all that it includes, before macros are replaced, with the files' virtual
 * paths; 16 hexadecimal digits, and nothing for a module of SPIR-V. Defines do not count. Throws FError as
 * FlattenShader does. */
DRYDOCK_API std::string FingerprintShader(const FShaderCompileRequest& Request);

/** Forgets what is in memory (files may have changed), keeps the cache on disk. */
DRYDOCK_API void ForgetCompiledShaders();

/** Forgets what was made of these files. */
DRYDOCK_API void ForgetCompiledShaders(const FShaderFiles& Files);

} // namespace Drydock
