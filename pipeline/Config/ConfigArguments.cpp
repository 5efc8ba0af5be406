// `--pp`, `--set` and `--exec` of the command line, and console variables by name.
#include "Config/ReadConfig.h"

#include "Config/ConfigReader.h"
#include "HAL/ConsoleVariableTools.h"
#include "PostProcessSettingsReflection.h"
#include "Scalability.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

const std::string CommandLine = CommandLineName;

/** "A=B" to A and B; reports what is not. */
bool SplitArgument(const std::string& Argument, const char* Option, std::string& OutName, std::string& OutValue,
	FConfigMessages& Messages)
{
	const size_t Equals = Argument.find('=');
	if (Equals == std::string::npos || Equals == 0)
	{
		Messages.Error(ErrorBadArgument, FConfigPlace{0, 0, Option}, "\"" + Argument + "\" is not NAME=VALUE");
		return false;
	}
	OutName = Argument.substr(0, Equals);
	OutValue = Argument.substr(Equals + 1);
	return true;
}

std::vector<std::string> GetVariableNames()
{
	std::vector<std::string> Names;
	IConsoleManager::Get().ForEachConsoleObjectThatStartsWith(
		FConsoleObjectVisitor::CreateLambda([&](const TCHAR* Name, IConsoleObject*) { Names.emplace_back(Name); }),
		TEXT(""));
	return Names;
}

bool IsScalabilityLevel(const std::string& Text)
{
	const int32 Level = FCString::Atoi(Text.c_str());
	return Level >= 0 && Level < NumScalabilityLevels;
}

const char* DescribeType(const IConsoleVariable& Variable)
{
	return Variable.IsVariableBool() ? "true or false" : Variable.IsVariableInt() ? "a whole number" : "a number";
}

/** Adds the input to the variables to set, run or print; reports mistakes. */
void AddConsoleInput(FConfig& Config, const std::string& Input, FConfigMessages& Messages)
{
	FString Name;
	FString Value;
	SplitConsoleInput(Input.c_str(), Name, Value);
	if (Name.IsEmpty())
	{
		return; // nothing between two commas
	}
	const FConfigVariable Variable{*Name, *Value, {0, 0, "--exec"}, EVariableSource::Console};
	const IConsoleObject* Object = IConsoleManager::Get().FindConsoleObject(*Name);
	const bool bAsks = Value.IsEmpty() || Value == "?";
	if (Object == nullptr || (IConsoleManager::Get().FindConsoleVariable(*Name) != nullptr && !bAsks))
	{
		CheckVariable(Variable, Messages);
	}
	Config.Variables.push_back(Variable);
}

} // namespace

void CheckVariable(const FConfigVariable& Variable, FConfigMessages& Messages)
{
	const IConsoleVariable* Found = IConsoleManager::Get().FindConsoleVariable(Variable.Name.c_str());
	if (Found == nullptr)
	{
		Messages.Error(ErrorUnknownVariable, Variable.Place,
			"unknown console variable " + Variable.Name + Messages.SuggestFrom(Variable.Name, GetVariableNames));
	}
	else if (!DoesConsoleVariableTake(*Found, Variable.Value.c_str()))
	{
		Messages.Error(ErrorWrongType, Variable.Place,
			Variable.Name + " must be " + DescribeType(*Found) + ", but is \"" + Variable.Value + "\"");
	}
	else if (Found->TestFlags(ECVF_ScalabilityGroup) && !IsScalabilityLevel(Variable.Value))
	{
		Messages.Error(ErrorBadValue, Variable.Place,
			Variable.Name + " must be a level from 0 to " + std::to_string(NumScalabilityLevels - 1) + ", but is " +
				Variable.Value);
	}
	else if (Found->TestFlags(ECVF_NotSimulated))
	{
		Messages.Warn(
			WarnIneffectiveValue, Variable.Place, Variable.Name + " is not simulated: nothing in drydock reads it");
	}
}

void SetEngineArgument(FConfig& Config, const std::string& Version, std::vector<FDiagnostic>& Diagnostics)
{
	if (FindEngineProfile(Version) == nullptr)
	{
		FConfigMessages(CommandLine, Diagnostics)
			.Error(ErrorBadArgument, FConfigPlace{0, 0, "--engine"},
				"\"" + Version + "\" is not one of the versions " + ListEngineVersions(", "));
		return;
	}
	Config.Engine = {Version, {0, 0, "--engine"}};
}

void AddPluginArgument(FConfig& Config, const std::string& File)
{
	const std::filesystem::path Path = std::filesystem::absolute(File).lexically_normal();
	const TConfigValue<std::string> Plugin{Path.string(), {0, 0, "--plugin"}};
	const auto Same = std::find_if(Config.Plugins.begin(), Config.Plugins.end(),
		[&Path](const TConfigValue<std::string>& Other)
		{ return std::filesystem::path(Other.Value).filename() == Path.filename(); });
	if (Same != Config.Plugins.end())
	{
		*Same = Plugin;
		return;
	}
	Config.Plugins.push_back(Plugin);
}

void AddOverlayArgument(FConfig& Config, const std::string& Folder)
{
	const std::string Path = Folder.empty() ? "" : std::filesystem::absolute(Folder).lexically_normal().string();
	Config.Overlays.push_back({{Path, {0, 0, "--overlay"}}, {}});
}

void AddSettingArgument(FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(CommandLine, Diagnostics);
	const FConfigPlace Place{0, 0, "--pp"};
	std::string Name;
	std::string Text;
	if (!SplitArgument(Argument, "--pp", Name, Text, Messages))
	{
		return;
	}
	const FSettingField* Field = FindSettingField(Name);
	if (Field == nullptr)
	{
		Messages.Error(ErrorUnknownSetting, Place, "unknown setting " + Name + Messages.SuggestSetting(Name));
		return;
	}
	FSettingValue Value;
	std::string Expected;
	if (!SettingFromText(*Field, Text, Value, Expected))
	{
		Messages.Error(ErrorWrongType, Place, Name + ": " + Expected + ", found \"" + Text + "\"");
		return;
	}
	if (!Field->IsInRange(Value))
	{
		Messages.Warn(WarnOutOfRange, Place, Name + " is outside its range; it is used as it is");
	}
	Field->Set(Config.CommandLine.Settings, Value);
	Field->SetOverridden(Config.CommandLine.Settings, true);
	Config.CommandLine.Places[Name] = Place;
}

void AddVariableArgument(FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(CommandLine, Diagnostics);
	FConfigVariable Variable;
	Variable.Place.Pointer = "--set";
	Variable.Source = EVariableSource::CommandLine;
	if (SplitArgument(Argument, "--set", Variable.Name, Variable.Value, Messages))
	{
		CheckVariable(Variable, Messages);
		Config.Variables.push_back(Variable);
	}
}

void AddExecArgument(FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(CommandLine, Diagnostics);
	const size_t NumBefore = Config.Variables.size();
	for (const std::string& Input : SplitText(Argument, ','))
	{
		AddConsoleInput(Config, Input, Messages);
	}
	if (Config.Variables.size() == NumBefore)
	{
		Messages.Error(
			ErrorBadArgument, FConfigPlace{0, 0, "--exec"}, "\"" + Argument + "\" names no console variable");
	}
}

} // namespace Drydock
