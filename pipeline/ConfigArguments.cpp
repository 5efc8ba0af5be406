// `--pp` and `--set` of the command line, and console variables by name. Source: drydock.
#include "ConfigReader.h"

#include "HAL/IConsoleManager.h"
#include "PostProcessSettingsReflection.h"

#include <charconv>
#include <cmath>

namespace Drydock
{

namespace
{

const std::string CommandLine = "command line";

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

bool IsNumber(const std::string& Text)
{
	double Number = 0.0;
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), Number);
	return Result.ec == std::errc() && Result.ptr == Text.data() + Text.size() && std::isfinite(Number);
}

bool IsWholeNumber(const std::string& Text)
{
	return IsNumber(Text) && std::stod(Text) == std::floor(std::stod(Text));
}

} // namespace

void CheckVariable(const FConfigVariable& Variable, FConfigMessages& Messages)
{
	const IConsoleVariable* Found = IConsoleManager::Get().FindConsoleVariable(Variable.Name.c_str());
	if (Found == nullptr)
	{
		Messages.Error(ErrorUnknownVariable, Variable.Place,
			"unknown console variable " + Variable.Name + Suggest(Variable.Name, GetVariableNames()));
	}
	else if (Found->IsVariableInt() && !IsWholeNumber(Variable.Value))
	{
		Messages.Error(
			ErrorWrongType, Variable.Place, Variable.Name + " is a whole number, not \"" + Variable.Value + "\"");
	}
	else if (Found->IsVariableFloat() && !IsNumber(Variable.Value))
	{
		Messages.Error(ErrorWrongType, Variable.Place, Variable.Name + " is a number, not \"" + Variable.Value + "\"");
	}
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
		Messages.Error(ErrorUnknownSetting, Place, "unknown setting " + Name + Suggest(Name, GetSettingNames()));
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
	const std::string NotBuilt = GetSettingNotBuiltReason(Name);
	if (!NotBuilt.empty())
	{
		Messages.Warn(WarnNotBuilt, Place, Name + " is not built yet: " + NotBuilt);
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
	if (SplitArgument(Argument, "--set", Variable.Name, Variable.Value, Messages))
	{
		CheckVariable(Variable, Messages);
		Config.Variables.push_back(Variable);
	}
}

} // namespace Drydock
