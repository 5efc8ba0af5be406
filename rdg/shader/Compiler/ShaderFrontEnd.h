// Compiles HLSL to SPIR-V by drydock's own front end (rdg/shader/Hlsl), or by the program that DRYDOCK_HLSL_COMPILER
// names, which has DRYDOCK_HLSL_COMPILER_SECONDS for a shader, 60 by default.
#pragma once

#include "Diagnostics.h"
#include "ShaderCompileRequest.h"
#include "ShaderSource.h"

namespace Drydock
{

/** SPIR-V of the flattened text. Throws FError: DD6010 for what the shader's author wrote, each message with virtual
 * path, line and column; DD6011 when the entry point does not exist; DD6012 when the program that DRYDOCK_HLSL_COMPILER
 * names is missing, hangs, crashes or writes nothing; DD6032 when it was killed and DD5004 when the temporary folder
 * cannot be written, both with exit code 3. */
DRYDOCK_API std::vector<uint32_t> CompileToSpirv(const FShaderSource& Source, const FShaderCompileRequest& Request);

/** How many texts this process has compiled. */
DRYDOCK_API int64_t GetNumCompiledTexts();

} // namespace Drydock
