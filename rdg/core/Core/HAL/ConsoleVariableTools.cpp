// Lists console variables, sets them with a check of the type, and resets them.
#include "HAL/ConsoleVariableTools.h"

#include "Diagnostics.h"
#include "TextTools.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace Drydock
{

namespace
{

/** Calls Function(Name, Variable) for every variable whose name starts with Prefix. */
template<typename FunctionType>
void ForEachVariable(const TCHAR* Prefix, FunctionType Function)
{
	IConsoleManager::Get().ForEachConsoleObjectThatStartsWith(
		FConsoleObjectVisitor::CreateLambda(
			[&Function](const TCHAR* Name, IConsoleObject* Object)
			{
				if (IConsoleVariable* Variable = Object->AsVariable())
				{
					Function(Name, *Variable);
				}
			}),
		Prefix);
}

/** Whether the whole of Text is a number of type T. from_chars takes no plus sign; people do. */
template<typename T>
bool IsNumber(const TCHAR* Text)
{
	std::string_view View(Text);
	if (View.starts_with('+') && !View.starts_with("+-"))
	{
		View.remove_prefix(1);
	}
	const std::optional<T> Value = Drydock::ParseAll<T>(View);
	return Value && std::isfinite(static_cast<double>(*Value));
}

bool IsBool(const FString& Text)
{
	static const TCHAR* const Words[] = {"true", "false", "on", "off", "yes", "no", "1", "0"};
	return std::any_of(std::begin(Words), std::end(Words), [&Text](const TCHAR* Word) { return Text == Word; });
}

/** Describes the texts that this variable takes, or null if Text is one. */
const TCHAR* FindExpectation(const IConsoleVariable& Variable, const TCHAR* Text)
{
	return Variable.IsVariableBool()    ? (IsBool(Text) ? nullptr : "a bool: true, false, on, off, yes, no, 1 or 0")
		   : Variable.IsVariableInt()   ? (IsNumber<int32>(Text) ? nullptr : "an int32: a whole number")
		   : Variable.IsVariableFloat() ? (IsNumber<float>(Text) ? nullptr : "a float: a number")
										: nullptr;
}

} // namespace

TArray<FConsoleVariableInfo> ListConsoleVariables(const TCHAR* Prefix)
{
	TArray<FConsoleVariableInfo> Infos;
	ForEachVariable(Prefix,
		[&Infos](const TCHAR* Name, const IConsoleVariable& Variable)
		{
			Infos.Add({Name, GetConsoleVariableTypeName(Variable), Variable.GetString(), Variable.GetDefaultValue(),
				GetConsoleVariableSetByName(Variable.GetFlags()), Variable.GetHelp(),
				Variable.TestFlags(ECVF_NotSimulated)});
		});
	return Infos;
}

bool TrySetConsoleVariable(const TCHAR* Name, const TCHAR* Text, EConsoleVariableFlags SetBy, FString& OutError)
{
	IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Name);
	if (Variable == nullptr)
	{
		std::vector<std::string> Names;
		ForEachVariable("", [&Names](const TCHAR* Other, const IConsoleVariable&) { Names.emplace_back(Other); });
		const std::string Nearest = FindNearestName(Name, Names);
		OutError = FString::Printf("unknown console variable %s", Name);
		if (!Nearest.empty())
		{
			OutError.Appendf("; did you mean %s?", Nearest.c_str());
		}
		return false;
	}
	if (const TCHAR* Expectation = FindExpectation(*Variable, Text))
	{
		OutError = FString::Printf("console variable %s expects %s, not \"%s\"", Name, Expectation, Text);
		return false;
	}
	Variable->Set(Text, SetBy);
	return true;
}

bool DoesConsoleVariableTake(const IConsoleVariable& Variable, const TCHAR* Text)
{
	return FindExpectation(Variable, Text) == nullptr;
}

FString DescribeRefusedSet(const TCHAR* Name, const IConsoleVariable& Variable, EConsoleVariableFlags SetBy)
{
	const EConsoleVariableFlags LastSetBy = Variable.GetFlags() & ECVF_SetByMask;
	if (static_cast<uint32>(SetBy & ECVF_SetByMask) >= static_cast<uint32>(LastSetBy))
	{
		return FString();
	}
	return FString::Printf("Setting the console variable '%s' with 'SetBy%s' was ignored as it is lower priority than "
						   "the previous 'SetBy%s'. Value remains '%s'",
		Name, GetConsoleVariableSetByName(SetBy), GetConsoleVariableSetByName(LastSetBy), *Variable.GetString());
}

FString DescribeConsoleVariable(const TCHAR* Name, const IConsoleVariable& Variable)
{
	return FString::Printf("%s = \"%s\"      LastSetBy: %s", Name, *Variable.GetString(),
		GetConsoleVariableSetByName(Variable.GetFlags()));
}

void SplitConsoleInput(const TCHAR* Input, FString& OutName, FString& OutValue)
{
	const FString Text = FString(Input).TrimStartAndEnd();
	const std::string_view View(*Text);
	const int32 NameLength = static_cast<int32>(std::min(View.find_first_of(" \t="), View.size()));
	OutName = Text.Left(NameLength);
	OutValue = Text.Mid(NameLength).TrimStart();
	if (OutValue.StartsWith("="))
	{
		OutValue = OutValue.Mid(1).TrimStart();
	}
	if (OutValue.Len() >= 2 && OutValue.StartsWith("\"") && OutValue.EndsWith("\""))
	{
		OutValue = OutValue.Mid(1, OutValue.Len() - 2);
	}
}

FConsoleVariableSnapshot::FConsoleVariableSnapshot()
{
	ForEachVariable("",
		[this](const TCHAR* Name, const IConsoleVariable& Variable) {
			Values.Add({Name, Variable.GetString(), Variable.GetFlags() & ECVF_SetByMask});
		});
}

FConsoleVariableSnapshot::~FConsoleVariableSnapshot()
{
	for (const FValue& Old : Values)
	{
		IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(*Old.Name);
		if (Variable != nullptr)
		{
			// A group's variables are put back by themselves, not by the group.
			const bool bGroup = Variable->TestFlags(ECVF_ScalabilityGroup);
			Variable->Restore(Old.Value, bGroup ? Old.SetBy | ECVF_Set_NoSinkCall_Unsafe : Old.SetBy);
		}
	}
}

void ResetConsoleVariables()
{
	ForEachVariable("", [](const TCHAR*, IConsoleVariable& Variable) { Variable.ResetToDefault(); });
}

const TCHAR* GetConsoleVariableSetByName(EConsoleVariableFlags Flags)
{
	static const TCHAR* const Names[] = {"Constructor", "Scalability", "GameSetting", "ProjectSetting",
		"SystemSettingsIni", "PluginLowPriority", "DeviceProfile", "PluginHighPriority", "GameOverride",
		"ConsoleVariablesIni", "Hotfix", "Preview", "Commandline", "Code", "Console"};
	const uint32 Priority = static_cast<uint32>(Flags) >> 24;
	return Priority < UE_ARRAY_COUNT(Names) ? Names[Priority] : "Unknown";
}

const TCHAR* GetConsoleVariableTypeName(const IConsoleVariable& Variable)
{
	return Variable.IsVariableBool()    ? "bool"
		   : Variable.IsVariableInt()   ? "int32"
		   : Variable.IsVariableFloat() ? "float"
										: "FString";
}

FScopedConsoleVariable::FScopedConsoleVariable(const TCHAR* Name, const FString& Value)
	: Variable(IConsoleManager::Get().FindConsoleVariable(Name))
{
	checkf(Variable != nullptr, "There is no console variable %s", Name);
	OldValue = Variable->GetString();
	OldSetBy = Variable->GetFlags() & ECVF_SetByMask;
	Variable->Set(*Value, ECVF_SetByConsole);
}

FScopedConsoleVariable::~FScopedConsoleVariable()
{
	Variable->Restore(OldValue, OldSetBy);
}

} // namespace Drydock
