// Adds the options that several verbs share to a verb's command line.
#include "Program/VerbOptions.h"

#include "Config/ConfigKeys.h"
#include "Diagnostics.h"
#include "Program/NumberList.h"
#include "ShaderCache.h"

#include <map>

namespace Drydock
{

FVerbCall AddVerbsBelow(FVerbOptions& Verb)
{
	Verb.RequireVerb();
	return nullptr;
}

void AddVariables(FVerbOptions& Verb, FRunOptions& Options)
{
	Verb.AddInOrder(
		"--set", "r.NAME=VALUE", [&Options](const std::string& Text) { Options.Variables.push_back(Text); },
		"Set a console variable; repeats; overrides the config");
	Verb.AddInOrder(
		"--exec", "\"A 1, B\"",
		[&Options](const std::string& Text) {
			Options.Exec.push_back({Text, Options.Variables.size()});
		},
		"Run console commands: \"r.A 1, r.B=2, r.C\" sets two and prints the third; repeats; overrides --set");
}

void AddTrust(FVerbOptions& Verb, FRunOptions& Options)
{
	Verb.AddFlag("--no-plugins", Options.bNoPlugins, "Refuse a config that names plugins, because plugins are code");
	Verb.AddFlag(
		"--read-only-cache", [] { FShaderCache::SetUse(EShaderCacheUse::ReadOnly); },
		"Write nothing to the shader cache; missing shaders are compiled for this run only");
}

void AddPlugins(FVerbOptions& Verb, FRunOptions& Options)
{
	Verb.AddRepeated("--plugin", "FILE", Options.Plugins,
		"Load a plugin; replaces the config's plugin of the same file name; repeats");
}

void AddConfig(FVerbOptions& Verb, FRunOptions& Options, bool bRequired)
{
	const FVerbOption Config = Verb.Add("CONFIG", Options.ConfigFile, "JSON config, such as configs/toon_bloom.json");
	if (bRequired)
	{
		Config.Require();
	}
	AddVariables(Verb, Options);
	Verb.AddRepeated(
		"--pp", "SETTING=VALUE", Options.Settings, "Set a post-process setting; repeats; overrides all volumes");
	Verb.Add("--frame", Options.Frame, "Use this frame of a sequence, by default the first; shaders see the number too")
		.RequireRange(0, 1 << 30)
		.SetType("N");
	Verb.Add("--engine", Options.Engine, "Behave as this engine version; overrides the config")
		.SetType(FindConfigKey("", "engine")->Of);
	Verb.AddRepeated("--overlay", "DIR", Options.Overlays,
		"Put an engine overlay in place of drydock's own files, beside the config's overlays; repeats");
	AddPlugins(Verb, Options);
	AddTrust(Verb, Options);
}

void AddThreads(FVerbOptions& Verb, FRunOptions& Options, const char* Doc)
{
	Verb.Add("--threads", Options.Threads, Doc).RequireRange(0, 1024).SetType("N");
}

void AddArithmetic(FVerbOptions& Verb, FRunOptions& Options)
{
	Verb.Add(
			"--precision", [&Options](const std::string& Name) { Options.bDouble = Name == "double"; },
			"Arithmetic of the shaders: float (default), or double with 64-bit storage")
		.RequireOneOf({"float", "double"});
	static const std::map<std::string, ERunStorage> Storages = {
		{"native", ERunStorage::Native}, {"float32", ERunStorage::Float32}, {"float64", ERunStorage::Float64}};
	Verb.Add(
			"--storage", [&Options](const std::string& Name) { Options.Storage = Storages.at(Name); },
			"Storage of textures: native (default; each its own format), float32, float64")
		.RequireOneOf({"native", "float32", "float64"});
	Verb.Add(
			"--backend",
			[&Options](const std::string& Name)
			{ Options.Variables.push_back(Name == "vulkan" ? "r.Drydock.Backend=1" : "r.Drydock.Backend=0"); },
			"Run shaders on the cpu (default), or on the installed vulkan driver; VK_DRIVER_FILES selects one of "
			"several")
		.RequireOneOf({"cpu", "vulkan"});
	AddThreads(Verb, Options, "Number of threads; 0: all cores (default). Every number gives the same bits");
}

std::array<double, 3> ParseLocation(const std::string& Text)
{
	const std::vector<double> Numbers = ParseNumbers("--at", Text, 3, 3, "X,Y,Z in centimetres such as 25,470,135");
	return {Numbers[0], Numbers[1], Numbers[2]};
}

std::string ChooseOutputFolder(const std::string& Folder, const FRunOptions& Options)
{
	return Folder.empty() ? GetDefaultOutputFolder(Options.ConfigFile) : Folder;
}

} // namespace Drydock
