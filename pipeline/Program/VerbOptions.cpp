// Adds the options that several verbs share to a verb's command line. The library comes first: the engine's macros,
// such as check, would change its names.
#include <CLI/CLI.hpp>

#include "Program/VerbOptions.h"

#include "Config/ConfigKeys.h"
#include "Diagnostics.h"
#include "ShaderCache.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace Drydock
{

CLI::Option* AddRepeated(
	CLI::App& Verb, const char* Name, const char* Type, std::vector<std::string>& Values, const char* Doc)
{
	return Verb.add_option(Name, Values, Doc)
		->expected(1)
		->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
		->allow_extra_args(false)
		->type_name(Type);
}

void AddVariables(CLI::App& Verb, FRunOptions& Options)
{
	const auto Add = [&Verb](const char* Name, const char* Type,
						 const std::function<void(const std::string&)>& Function, const char* Doc)
	{
		Verb.add_option_function<std::string>(Name, Function, Doc)
			->expected(1)
			->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
			->trigger_on_parse()
			->type_name(Type);
	};
	Add(
		"--set", "r.NAME=VALUE", [&Options](const std::string& Text) { Options.Variables.push_back(Text); },
		"Set a console variable; repeats; beats the config");
	Add(
		"--exec", "\"A 1, B\"",
		[&Options](const std::string& Text) {
			Options.Exec.push_back({Text, Options.Variables.size()});
		},
		"Tell the console: \"r.A 1, r.B=2, r.C\" sets two, prints the third; repeats; beats --set");
}

void AddTrust(CLI::App& Verb, FRunOptions& Options)
{
	Verb.add_flag("--no-plugins", Options.bNoPlugins, "Refuse a config that names plugins: they are code that is run");
	Verb.add_flag_callback(
		"--read-only-cache", [] { FShaderCache::SetUse(EShaderCacheUse::ReadOnly); },
		"Write nothing to the shader cache; what it lacks is compiled for this run alone");
}

void AddConfig(CLI::App& Verb, FRunOptions& Options)
{
	Verb.add_option("CONFIG", Options.ConfigFile, "JSON config, such as configs/toon_bloom.json")->required();
	AddVariables(Verb, Options);
	AddRepeated(
		Verb, "--pp", "SETTING=VALUE", Options.Settings, "Set a post-process setting; repeats; beats all volumes");
	RequireRange(Verb.add_option(
					 "--frame", Options.Frame, "Which frame of a sequence, by default the first; shaders see it too"),
		0, 1 << 30)
		->type_name("N");
	Verb.add_option("--engine", Options.Engine, "Engine version whose behaviour holds; beats the config's")
		->type_name(FindConfigKey("", "engine")->Of);
	AddRepeated(Verb, "--plugin", "FILE", Options.Plugins,
		"Load a plugin, in place of the config's of the same file name; repeats");
	AddTrust(Verb, Options);
}

void AddThreads(CLI::App& Verb, FRunOptions& Options, const char* Doc)
{
	RequireRange(Verb.add_option_function<int>(
					 "--threads", [&Options](int Threads) { Options.Threads = Threads; }, Doc),
		0, 1024)
		->type_name("N");
}

void AddArithmetic(CLI::App& Verb, FRunOptions& Options)
{
	RequireOneOf(Verb.add_option_function<std::string>(
					 "--precision", [&Options](const std::string& Name) { Options.bDouble = Name == "double"; },
					 "Arithmetic of the shaders: float (default) or double, with 64-bit storage"),
		{"float", "double"});
	static const std::map<std::string, ERunStorage> Storages = {
		{"native", ERunStorage::Native}, {"float32", ERunStorage::Float32}, {"float64", ERunStorage::Float64}};
	RequireOneOf(Verb.add_option_function<std::string>(
					 "--storage", [&Options](const std::string& Name) { Options.Storage = Storages.at(Name); },
					 "Storage of textures: native (their own formats, default), float32, float64"),
		{"native", "float32", "float64"});
	RequireOneOf(
		Verb.add_option_function<std::string>(
			"--backend",
			[&Options](const std::string& Name)
			{ Options.Variables.push_back(Name == "vulkan" ? "r.Drydock.Backend=1" : "r.Drydock.Backend=0"); },
			"What shaders run on: cpu (default), or vulkan, the driver that is there; VK_DRIVER_FILES names one "
			"of several"),
		{"cpu", "vulkan"});
	AddThreads(Verb, Options, "Threads; 0: all cores (default). The result is the same bits for any number");
}

// Without the descriptions that CLI11 would add to the help.

CLI::Option* RequireRange(CLI::Option* Option, int Least, int Most)
{
	return Option->check(CLI::Range(Least, Most).description(""));
}

CLI::Option* RequireNonNegative(CLI::Option* Option)
{
	return Option->check(CLI::NonNegativeNumber.description(""));
}

CLI::Option* RequireOneOf(CLI::Option* Option, const std::vector<std::string>& Words)
{
	const auto Join = [Words](const char* Between)
	{
		std::string Joined;
		for (const std::string& Word : Words)
		{
			Joined += (Joined.empty() ? "" : Between) + Word;
		}
		return Joined;
	};
	const auto Explain = [Words, Join](const std::string& Word)
	{
		if (std::find(Words.begin(), Words.end(), Word) != Words.end())
		{
			return std::string();
		}
		const std::string Nearest = FindNearestName(Word, Words);
		return '"' + Word + "\" is none of " + Join(", ") + (Nearest.empty() ? "" : "; did you mean " + Nearest + "?");
	};
	return Option->check(Explain)->type_name(Join("|"));
}

std::array<double, 3> ParseLocation(const std::string& Text)
{
	std::array<double, 3> Location = {};
	const char* At = Text.c_str();
	const char* const End = At + Text.size();
	bool bGood = true;
	for (size_t Index = 0; bGood && Index < Location.size(); ++Index)
	{
		while (*At == ' ')
		{
			++At;
		}
		const std::from_chars_result Result = std::from_chars(At, End, Location[Index]);
		bGood = Result.ec == std::errc() && std::isfinite(Location[Index]);
		At = Result.ptr;
		const bool bLast = Index + 1 == Location.size();
		bGood = bGood && (bLast ? At == End : *At == ',');
		At += bLast ? 0 : 1;
	}
	if (!bGood)
	{
		throw FError({.Code = ErrorBadArgument,
						 .Message = "expected X,Y,Z in centimetres such as 25,470,135, found \"" + Text + "\"",
						 .Where = "--at"},
			ExitUsage);
	}
	return Location;
}

std::string ChooseOutputFolder(const std::string& Folder, const FRunOptions& Options)
{
	return Folder.empty() ? GetDefaultOutputFolder(Options.ConfigFile) : Folder;
}

} // namespace Drydock
