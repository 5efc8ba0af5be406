// Collects what the front end warns of in the shaders of plugins and overlays while a frame is compiled.
#pragma once

#include "Diagnostics.h"
#include "ShaderCompilation.h"
#include "ShaderCompileRequest.h"

#include <vector>

namespace Drydock
{

/** Notes the shaders that are compiled or taken from the cache while it lives, but for those that drydock ships. */
class DRYDOCK_API FShaderWarnings
{
public:
	FShaderWarnings();

	/** Warnings DD6024 of these shaders, each once, with file and line; no warning for a shader that does not compile.
	 */
	std::vector<FDiagnostic> Find() const;

private:
	std::vector<FShaderCompileRequest> Requests;
	FScopedCompileListener Listener;
};

} // namespace Drydock
