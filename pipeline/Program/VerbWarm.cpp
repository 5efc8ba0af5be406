// `drydock warm`: compiles the shaders of configs, which the build does so that a first run needs no compiler.
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramOutput.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "ShaderCache.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace Drydock
{

namespace
{

struct FWarmOptions
{
	std::vector<std::string> Configs;
	std::string CacheFolder; // empty: the usual one
	bool bNoPlugins = false;
	bool bAll = false;
};

int Warm(const FWarmOptions& Options)
{
	if (!Options.CacheFolder.empty())
	{
		setenv("DRYDOCK_CACHE_DIR", Options.CacheFolder.c_str(), 1);
	}
	FShaderCache::SetUse(EShaderCacheUse::Required);
	for (const std::string& Config : Options.Configs)
	{
		// Running is what asks for exactly the shaders that the config uses.
		FRunOptions Run;
		Run.ConfigFile = Config;
		Run.bNoPlugins = Options.bNoPlugins;
		const FRunResult Result = RunConfig(Run);
		PrintText(
			stderr, "warmed the shaders of " + Config + ": " + std::to_string(Result.Passes.size()) + " passes\n");
		if (Options.bAll)
		{
			const FPluginShaders Shaders = WarmPluginShaders(Run);
			PrintDiagnostics(Shaders.Notes);
			PrintText(stderr, "warmed " + Shaders.Describe() + "\n");
		}
	}
	return ExitDone;
}

} // namespace

FVerbCall AddWarmOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FWarmOptions>();
	Verb.Add("CONFIG", Options->Configs, "JSON configs").Require();
	Verb.Add("--cache", Options->CacheFolder, "Folder of the cache; the usual one by default").SetType("DIR");
	Verb.AddFlag("--no-plugins", Options->bNoPlugins, "Refuse a config that names plugins, because plugins are code");
	Verb.AddFlag("--all", Options->bAll,
		"Compile every shader class of the plugins, even if the frame does not use it, up to 256 permutations each");
	return CallWith(Options, Warm);
}

} // namespace Drydock
