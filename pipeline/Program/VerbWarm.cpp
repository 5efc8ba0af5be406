// `drydock warm`: what the build calls so that a first run needs no compiler. Source: drydock.
#include "Program/Verbs.h"
#include "Run/Run.h"

#include <cstdio>
#include <cstdlib>

namespace Drydock
{

int WarmVerb(const std::vector<std::string>& Configs, const std::string& Folder)
{
	if (!Folder.empty())
	{
		setenv("DRYDOCK_CACHE_DIR", Folder.c_str(), 1);
	}
	for (const std::string& Config : Configs)
	{
		// Running is what asks for exactly the shaders that the config uses.
		FRunOptions Options;
		Options.ConfigFile = Config;
		const FRunResult Result = RunConfig(Options);
		std::fprintf(stderr, "warmed the shaders of %s: %zu passes\n", Config.c_str(), Result.Passes.size());
	}
	return ExitDone;
}

} // namespace Drydock
