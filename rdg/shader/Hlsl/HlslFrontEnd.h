// Compiles preprocessed HLSL to SPIR-V: reads, analyses, emits, optimises.
#pragma once

#include "HlslAnalysis.h"
#include "ShaderCompileRequest.h"

namespace Drydock::Hlsl
{

/** Text: preprocessed, with `#line`, nothing rewritten, the declarations of uniform buffers before it. Throws FError
 * DD6010 and DD6011 with all that was found. */
DRYDOCK_API std::vector<uint32_t> Compile(const std::string& Text, const FShaderCompileRequest& Request);

/** What D3D's compilers warn of in what the entry reaches, in the order of the text; none where the text has errors. */
DRYDOCK_API std::vector<FDiagnostic> FindWarnings(const std::string& Text, const FShaderCompileRequest& Request);

/** File and line of the statements that the entry reaches and that write some components of a texel only; none where
 * the text has errors. */
DRYDOCK_API std::vector<std::pair<std::string, int>> FindPartialStores(
	const std::string& Text, const FShaderCompileRequest& Request);

} // namespace Drydock::Hlsl
