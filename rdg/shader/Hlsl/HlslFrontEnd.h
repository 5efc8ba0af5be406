// Compiles preprocessed HLSL to SPIR-V: reads, analyses, emits, optimises.
#pragma once

#include "HlslAnalysis.h"
#include "ShaderCompileRequest.h"

namespace Drydock::Hlsl
{

/** Reads and analyses a text, for Compile and for those who look at the program or its warnings. Throws FError as
 * Compile does. */
DRYDOCK_API FAnalysis Read(const std::string& Text, const FShaderCompileRequest& Request);

/** Text: preprocessed, with `#line`, nothing rewritten, the declarations of uniform buffers before it. Throws FError
 * DD6010 and DD6011 with all that was found. */
DRYDOCK_API std::vector<uint32_t> Compile(const std::string& Text, const FShaderCompileRequest& Request);

} // namespace Drydock::Hlsl
