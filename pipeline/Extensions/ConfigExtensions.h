// The config's `extensions` and `passes`, matched with the factories there are: types, hooks, parameters, resources.
// It comes after the plugins are loaded, because they bring factories.
#pragma once

#include "Config/Config.h"
#include "ExtensionFactory.h"
#include "PassFactory.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** An extension that the config asks for. */
struct FExtensionRequest
{
	std::string Type;
	FExtensionArguments Arguments;
};

/** A pass that the config inserts. */
struct FPassRequest
{
	std::string Type;
	std::string Name;                             // under which later passes find its result
	std::string Hook;                             // PrePostProcessPass, or a name of EPostProcessingPass
	std::map<std::string, std::string> Resources; // by the name of the input
	FParameterValues Values;
	bool bReplace = true; // the result is the picture from then on
};

/** Mistakes are appended to Diagnostics; what has one is left out. */
DRYDOCK_API std::vector<FExtensionRequest> ReadExtensionRequests(
	const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);
DRYDOCK_API std::vector<FPassRequest> ReadPassRequests(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** Resources that an inserted pass can read beside the results of earlier ones: the picture, and the scene textures. */
DRYDOCK_API std::vector<std::string> GetPassResources();

} // namespace Drydock
