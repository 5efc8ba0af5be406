// Compiles HLSL to SPIR-V by glslang, in a process that is kept (FrontEndProcess.h): a crash or an endless loop of its
// parser costs one error message. DRYDOCK_GLSLANG names a glslangValidator to run for each shader in its place,
// DRYDOCK_GLSLANG_SECONDS the time for a shader, 60 by default.
#pragma once

#include "Diagnostics.h"
#include "ShaderCompileRequest.h"
#include "ShaderSource.h"

namespace Drydock
{

/** SPIR-V of the flattened text. Throws FError: DD6010 for what the shader's author wrote, each message with virtual
 * path and line; DD6011 when the entry point does not exist; DD6012 when the front end is missing, hangs or crashes
 * (on which line, found by giving it less and less of the text); DD6032 when it was killed and DD5004 when the
 * temporary folder cannot be written, both with exit code 3. */
DRYDOCK_API std::vector<uint32_t> CompileToSpirv(const FShaderSource& Source, const FShaderCompileRequest& Request);

/** The errors in glslang's output, in its order, without its own summary lines. */
DRYDOCK_API std::vector<FDiagnostic> ParseFrontEndMessages(
	const std::string& Output, const FShaderCompileRequest& Request);

} // namespace Drydock
