// Collects fingerprints of what a run or a sequence depends on, and the words of the command line that matter.
#include "Run/RunInputs.h"

#include "Extensions/Plugins.h"
#include "HAL/ConsoleVariableTools.h"
#include "InstallPaths.h"
#include "PostProcessSettingsReflection.h"
#include "Text/Fingerprint.h"
#include "Text/TextFile.h"
#include "Text/Version.h"
#include "Text/WatchedFiles.h"
#include "TextTools.h"
#include "Tonemap/PostProcessTonemap.h"

#include <algorithm>
#include <array>
#include <dlfcn.h>
#include <filesystem>
#include <functional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const char* const FilePrefix = "file ";

/** The libraries of the storeys, each by one of its functions: another build may compute other bits. */
std::string FingerprintOfDrydock()
{
	std::string Text = GetVersion();
	for (const void* const Function :
		{reinterpret_cast<const void*>(&FindInstalled), reinterpret_cast<const void*>(&GetSettingFields),
			reinterpret_cast<const void*>(&AddTonemapPass), reinterpret_cast<const void*>(&FindRunInputs)})
	{
		Dl_info Info = {};
		const bool bFound = dladdr(Function, &Info) != 0 && Info.dli_fname;
		Text += " " + (bFound ? FingerprintFile(Info.dli_fname) : "");
	}
	return Text;
}

/** Every shader file that a pass may be built of, by name and contents. */
std::string FingerprintShaders()
{
	FWatchedFiles Shaders;
	Shaders.AddShaders();
	FFingerprint Fingerprint;
	for (const std::string& Path : Shaders.GetPaths())
	{
		Fingerprint.AddText(Files::path(Path).filename().string());
		Fingerprint.AddText(FingerprintFile(Path));
	}
	return Fingerprint.Get();
}

/** A path of the command line, as one from the config's folder. */
std::string MakeRelative(const std::string& Path, const FConfig& Config)
{
	const Files::path From = Files::absolute(Config.File).parent_path().lexically_normal();
	return Files::absolute(Path).lexically_normal().lexically_relative(From).generic_string();
}

const std::array Precisions = {"float", "double"};
const std::array Storages = {"", "native", "float32", "float64"};

/** An option of the command line that changes a bit of the outputs. Values: of the command line; one empty word where
 * a flag is given. */
struct FRunArgument
{
	const char* Name;
	bool bValue; // not a flag
	bool bPath;
	std::function<std::vector<std::string>(const FRunOptions& Options)> List;
	std::function<void(FRunOptions& Options, const std::string& Value)> Take;
};

std::vector<std::string> ListIf(bool bGiven, const std::string& Value = "")
{
	return bGiven ? std::vector<std::string>{Value} : std::vector<std::string>();
}

FRunArgument MakeFlag(const char* Name, bool FRunOptions::*Member)
{
	return {Name, false, false, [Member](const FRunOptions& Options) { return ListIf(Options.*Member); },
		[Member](FRunOptions& Options, const std::string&)
		{
			Options.*Member = true;
		}};
}

FRunArgument MakeList(const char* Name, bool bPath, std::vector<std::string> FRunOptions::*Member)
{
	return {Name, true, bPath, [Member](const FRunOptions& Options) { return Options.*Member; },
		[Member](FRunOptions& Options, const std::string& Value)
		{
			(Options.*Member).push_back(Value);
		}};
}

/** --set and --exec, whose order matters, are not among them. */
const std::vector<FRunArgument>& GetRunArguments()
{
	static const std::vector<FRunArgument> Arguments = {MakeList("--pp", false, &FRunOptions::Settings),
		{"--frame", true, false,
			[](const FRunOptions& Options)
			{ return ListIf(Options.Frame.has_value(), std::to_string(Options.Frame.value_or(0))); },
			[](FRunOptions& Options, const std::string& Value)
			{
				Options.Frame = std::stoi(Value);
			}},
		{"--engine", true, false,
			[](const FRunOptions& Options) { return ListIf(!Options.Engine.empty(), Options.Engine); },
			[](FRunOptions& Options, const std::string& Value)
			{
				Options.Engine = Value;
			}},
		MakeList("--overlay", true, &FRunOptions::Overlays), MakeList("--plugin", true, &FRunOptions::Plugins),
		MakeFlag("--fingerprints", &FRunOptions::bFingerprints),
		MakeFlag("--measure-effects", &FRunOptions::bMeasureEffects),
		{"--outputs", true, false,
			[](const FRunOptions& Options)
			{
				std::string Names;
				for (const EOutputKind Kind : Options.Write.value_or(FOutputKinds()))
				{
					Names += (Names.empty() ? "" : ",") + std::string(GetOutputKindNames()[static_cast<size_t>(Kind)]);
				}
				return ListIf(Options.Write.has_value(), Names);
			},
			[](FRunOptions& Options, const std::string& Value)
			{
				Options.Write = MakeOutputKinds(SplitText(Value, ','));
			}},
		MakeList("--dump", false, &FRunOptions::Dump), MakeFlag("--no-skip", &FRunOptions::bNoSkip),
		{"--precision", true, false, [](const FRunOptions& Options) { return ListIf(Options.bDouble, Precisions[1]); },
			[](FRunOptions& Options, const std::string& Value)
			{
				Options.bDouble = Value == Precisions[1];
			}},
		{"--storage", true, false,
			[](const FRunOptions& Options)
			{ return ListIf(Options.Storage != ERunStorage::Default, Storages[static_cast<size_t>(Options.Storage)]); },
			[](FRunOptions& Options, const std::string& Value)
			{
				const auto Found = std::ranges::find(Storages, Value);
				Options.Storage =
					Found == Storages.end() ? ERunStorage::Default : static_cast<ERunStorage>(Found - Storages.begin());
			}}};
	return Arguments;
}

std::string DescribeOptions(const FRunOptions& Options, const FConfig& Config)
{
	std::string Text;
	for (const std::string& Word : ListRunArguments(Options, Config))
	{
		const bool bQuoted = Word.find(' ') != std::string::npos;
		Text += (Text.empty() ? "" : " ") + (bQuoted ? '"' + Word + '"' : Word);
	}
	return Text;
}

void AddFile(const std::string& Name, const std::string& Path, FRunInputs& Inputs)
{
	std::error_code Ignored;
	if (Files::is_regular_file(Path, Ignored))
	{
		Inputs[FilePrefix + Name] = FingerprintFile(Path);
	}
}

void AddIniFiles(const std::string& Plugin, const FConfig& Config, FRunInputs& Inputs)
{
	for (const std::string& Path : FindPluginIniFiles(Plugin))
	{
		AddFile(MakeRelative(Path, Config), Path, Inputs);
	}
}

void AddFiles(const FJsonValue& Value, const FConfig& Config, FRunInputs& Inputs)
{
	if (Value.Type == EJsonType::String && !Value.String.empty() && Value.Pointer != "/$schema")
	{
		AddFile(Value.String, Config.Resolve(Value.String), Inputs);
	}
	for (const FJsonValue& Element : Value.Elements)
	{
		AddFiles(Element, Config, Inputs);
	}
	for (const FJsonMember& Member : Value.Members)
	{
		if (Member.Value.Pointer != "/sweep") // which names files of other runs
		{
			AddFiles(Member.Value, Config, Inputs);
		}
	}
}

} // namespace

std::vector<std::string> ListRunArguments(const FRunOptions& Options, const FConfig& Config)
{
	std::vector<std::string> Words;
	size_t NumVariables = 0;
	const auto AddVariables = [&](size_t End)
	{
		for (; NumVariables < std::min(End, Options.Variables.size()); ++NumVariables)
		{
			Words.insert(Words.end(), {"--set", Options.Variables[NumVariables]});
		}
	};
	for (const FRunOptions::FExec& Exec : Options.Exec)
	{
		AddVariables(Exec.NumVariablesBefore);
		Words.insert(Words.end(), {"--exec", Exec.Text});
	}
	AddVariables(Options.Variables.size());
	for (const FRunArgument& Argument : GetRunArguments())
	{
		for (const std::string& Value : Argument.List(Options))
		{
			Words.push_back(Argument.Name);
			if (Argument.bValue)
			{
				Words.push_back(Argument.bPath ? MakeRelative(Value, Config) : Value);
			}
		}
	}
	return Words;
}

bool TakeRunArguments(const std::vector<std::string>& Words, const std::string& ConfigFile, FRunOptions& Options)
{
	for (size_t Index = 0; Index < Words.size(); ++Index)
	{
		const std::string& Name = Words[Index];
		const auto Found = std::ranges::find(GetRunArguments(), Name, &FRunArgument::Name);
		const bool bVariable = Name == "--set" || Name == "--exec";
		const bool bValue = bVariable || (Found != GetRunArguments().end() && Found->bValue);
		if ((!bVariable && Found == GetRunArguments().end()) || (bValue && Index + 1 == Words.size()))
		{
			return false;
		}
		const std::string Value = bValue ? Words[++Index] : "";
		if (Name == "--set")
		{
			Options.Variables.push_back(Value);
		}
		else if (Name == "--exec")
		{
			Options.Exec.push_back({Value, Options.Variables.size()});
		}
		else
		{
			Found->Take(Options, Found->bPath ? (Files::path(ConfigFile).parent_path() / Value).string() : Value);
		}
	}
	return true;
}

std::vector<FRunVariable> ListRunVariables()
{
	std::vector<FRunVariable> Variables;
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		if (Info.SetBy != TEXT("Constructor") && Info.Name != TEXT("r.Drydock.Threads"))
		{
			const std::string By = Info.SetBy == TEXT("ConsoleVariablesIni") ? "config"
								   : Info.SetBy == TEXT("Commandline")       ? "command line"
																			 : *Info.SetBy;
			Variables.push_back({*Info.Name, *Info.Value, By});
		}
	}
	return Variables;
}

FRunInputs FindRunInputs(const FRunOptions& Options, const FConfig& Config)
{
	const std::string Text = Options.ConfigText ? *Options.ConfigText : ReadTextFile(Options.ConfigFile);
	FFingerprint Fingerprint;
	Fingerprint.AddText(Text);
	FRunInputs Inputs = {{"config", Fingerprint.Get()}, {"shaders", FingerprintShaders()}};
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	AddFiles(ParseJson(Text, Options.ConfigFile, Ignored, bSyntaxError), Config, Inputs);
	if (Config.Scene.Frame)
	{
		AddFile(Config.Scene.File.Value, Config.Resolve(Config.Scene.File.Value), Inputs);
	}
	for (const std::string& Plugin : Options.Plugins)
	{
		AddFile(MakeRelative(Plugin, Config), Plugin, Inputs);
		AddIniFiles(Plugin, Config, Inputs);
	}
	for (const TConfigValue<std::string>& Plugin : Config.Plugins)
	{
		AddIniFiles(Config.Resolve(Plugin.Value), Config, Inputs);
	}
	return Inputs;
}

FRunInputs FindSequenceInputs(const FRunOptions& Options, FConfig Config)
{
	Config.Scene.Frame.reset(); // frames count for themselves
	FRunInputs Inputs = FindRunInputs(Options, Config);
	Inputs.insert({{"drydock", FingerprintOfDrydock()}, {"path", Options.ConfigFile},
		{"options", DescribeOptions(Options, Config)}});
	return Inputs;
}

std::vector<std::string> DescribeChanges(const FRunInputs& Before, const FRunInputs& Now)
{
	std::vector<std::string> Changes;
	FRunInputs All = Before;
	All.insert(Now.begin(), Now.end());
	const auto Quote = [](const std::string& Text)
	{
		return Text.empty() ? std::string("none") : Text;
	};
	for (const auto& [Name, Ignored] : All)
	{
		const auto Old = Before.find(Name);
		const auto New = Now.find(Name);
		if (Old == Before.end() || New == Now.end())
		{
			Changes.push_back(Name + (Old == Before.end() ? " is new" : " is gone"));
		}
		else if (Old->second != New->second)
		{
			const bool bText = Name == "options" || Name == "path";
			Changes.push_back(Name == "options"
								  ? "the options were " + Quote(Old->second) + " and are " + Quote(New->second)
							  : bText ? "the config was named " + Old->second + " and is named " + New->second
							  : Name.starts_with(FilePrefix) ? Name + " has changed"
							  : Name == "shaders"            ? "a shader has changed"
							  : Name == "drydock"            ? "drydock is another build"
															 : "the " + Name + " has changed");
		}
	}
	return Changes;
}

} // namespace Drydock
