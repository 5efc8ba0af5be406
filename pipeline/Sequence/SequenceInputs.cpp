// Collects fingerprints of what a sequence depends on.
#include "Sequence/SequenceInputs.h"

#include "Extensions/Plugins.h"
#include "InstallPaths.h"
#include "PostProcessSettingsReflection.h"
#include "Text/Fingerprint.h"
#include "Text/TextFile.h"
#include "Text/Version.h"
#include "Text/WatchedFiles.h"
#include "Tonemap/PostProcessTonemap.h"

#include <algorithm>
#include <dlfcn.h>
#include <filesystem>

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
			reinterpret_cast<const void*>(&AddTonemapPass), reinterpret_cast<const void*>(&FindSequenceInputs)})
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

/** All that the command line says of what a frame is. */
std::string DescribeOptions(const FRunOptions& Options)
{
	std::string Text;
	const auto Add = [&Text](const std::string& Part)
	{
		Text += (Text.empty() ? "" : " ") + Part;
	};
	size_t NumVariables = 0;
	const auto AddVariables = [&](size_t End)
	{
		for (; NumVariables < std::min(End, Options.Variables.size()); ++NumVariables)
		{
			Add("--set " + Options.Variables[NumVariables]);
		}
	};
	for (const FRunOptions::FExec& Exec : Options.Exec)
	{
		AddVariables(Exec.NumVariablesBefore);
		Add("--exec \"" + Exec.Text + "\"");
	}
	AddVariables(Options.Variables.size());
	for (const std::string& Setting : Options.Settings)
	{
		Add("--pp " + Setting);
	}
	if (!Options.Engine.empty())
	{
		Add("--engine " + Options.Engine);
	}
	for (const std::string& Plugin : Options.Plugins)
	{
		Add("--plugin " + Plugin);
	}
	if (Options.bFingerprints)
	{
		Add("--fingerprints");
	}
	if (Options.Write)
	{
		Add("--outputs");
		for (const EOutputKind Kind : *Options.Write)
		{
			Add(GetOutputKindNames()[static_cast<size_t>(Kind)]);
		}
	}
	for (const std::string& Pattern : Options.Dump)
	{
		Add("--dump " + Pattern);
	}
	if (Options.bNoSkip)
	{
		Add("--no-skip");
	}
	if (Options.bDouble)
	{
		Add("--precision double");
	}
	const char* const Storages[] = {"", "native", "float32", "float64"};
	if (Options.Storage != ERunStorage::Default)
	{
		Add(std::string("--storage ") + Storages[static_cast<int>(Options.Storage)]);
	}
	return Text;
}

void AddFile(const std::string& Name, const std::string& Path, FSequenceInputs& Inputs)
{
	std::error_code Ignored;
	if (Files::is_regular_file(Path, Ignored))
	{
		Inputs[FilePrefix + Name] = FingerprintFile(Path);
	}
}

void AddIniFiles(const std::string& Plugin, FSequenceInputs& Inputs)
{
	for (const std::string& Path : FindPluginIniFiles(Plugin))
	{
		AddFile(Path, Path, Inputs);
	}
}

void AddFiles(const FJsonValue& Value, const FConfig& Config, FSequenceInputs& Inputs)
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
		AddFiles(Member.Value, Config, Inputs);
	}
}

} // namespace

FSequenceInputs FindSequenceInputs(const FRunOptions& Options, const FConfig& Config)
{
	const std::string Text = Options.ConfigText ? *Options.ConfigText : ReadTextFile(Options.ConfigFile);
	FFingerprint Fingerprint;
	Fingerprint.AddText(Text);
	FSequenceInputs Inputs = {{"drydock", FingerprintOfDrydock()}, {"config", Fingerprint.Get()},
		{"path", Options.ConfigFile}, {"options", DescribeOptions(Options)}, {"shaders", FingerprintShaders()}};
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	AddFiles(ParseJson(Text, Options.ConfigFile, Ignored, bSyntaxError), Config, Inputs);
	for (const std::string& Plugin : Options.Plugins)
	{
		AddFile(Plugin, Plugin, Inputs);
		AddIniFiles(Plugin, Inputs);
	}
	for (const TConfigValue<std::string>& Plugin : Config.Plugins)
	{
		AddIniFiles(Config.Resolve(Plugin.Value), Inputs);
	}
	return Inputs;
}

std::vector<std::string> DescribeChanges(const FSequenceInputs& Before, const FSequenceInputs& Now)
{
	std::vector<std::string> Changes;
	FSequenceInputs All = Before;
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
