// Recognises features that the CPU tier has no stage or hardware for (ray tracing, geometry, tessellation, meshes,
// multisampling): one message with a way round replaces the front end's messages.
#pragma once

#include "ShaderCompileRequest.h"

#include "Diagnostics.h"

#include <optional>

namespace Drydock
{

/** Offset of Name in Line as a word of its own; npos where Line does not have it. */
size_t FindWord(const std::string& Line, const std::string& Name);

/** "ray tracing ('TraceRay') does not run on the CPU tier; WAY ROUND" of a line that has such a word; else empty. */
std::string ExplainLeftOut(const std::string& Line);

/** The same, as DD6020, of the attributes and the signature of the request's entry point, which the front end may take
 * for those of a pixel shader. Text: flattened. */
std::optional<FDiagnostic> FindLeftOutEntry(const std::string& Text, const FShaderCompileRequest& Request);

} // namespace Drydock
