// Checks names and values of assignments against settings, console variables and places of the config.
#include "Budget/RunAssignment.h"

#include "Config/ConfigPlaces.h"
#include "Config/ReadConfig.h"
#include "HAL/IConsoleManager.h"
#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

namespace Drydock
{

std::optional<std::string> ReadValueText(const FJsonValue& Value, FConfigMessages& Messages)
{
	switch (Value.Type)
	{
	case EJsonType::Number:
		return NumberText(Value.Number);
	case EJsonType::String:
		return Value.String;
	case EJsonType::Bool:
		return Value.Bool ? "true" : "false";
	case EJsonType::Invalid:
		return std::nullopt; // reported
	default:
		Messages.Error(ErrorWrongType, Value,
			std::string("expected a number, a string or true or false, found ") + Value.Describe());
		return std::nullopt;
	}
}

void CheckIsOneOf(const FJsonValue& At, const std::string& Value, const std::vector<std::string>& Names,
	const char* What, FConfigMessages& Messages)
{
	if (!Contains(Names, Value))
	{
		Messages.Error(ErrorUnknownValue, At,
			std::string("there is no ") + What + " \"" + Value + "\": " + JoinText(Names) +
				Messages.Suggest(Value, Names));
	}
}

FRunAssignmentReader::FRunAssignmentReader(
	std::string InFile, std::vector<std::string> InSpecial, std::vector<FDiagnostic>& InDiagnostics)
	: File(std::move(InFile))
	, Special(std::move(InSpecial))
	, Diagnostics(InDiagnostics)
	, Messages(File, InDiagnostics)
{
}

bool FRunAssignmentReader::CheckName(const std::string& Name, const FJsonValue& At)
{
	const bool bKnown = Contains(Special, Name) || IsConfigPlace(Name) || FindSettingField(Name) != nullptr ||
						IConsoleManager::Get().FindConsoleVariable(Name.c_str()) != nullptr;
	if (!bKnown)
	{
		std::vector<std::string> Names = Special;
		for (const FSettingField& Field : GetSettingFields())
		{
			Names.emplace_back(Field.Name);
		}
		IConsoleManager::Get().ForEachConsoleObjectThatStartsWith(
			FConsoleObjectVisitor::CreateLambda(
				[&](const TCHAR* Variable, IConsoleObject*) { Names.emplace_back(Variable); }),
			TEXT(""));
		Messages.Error(ErrorUnknownValue, At,
			"\"" + Name + "\" is not a setting, a console variable, " + JoinText(Special) +
				" or a place such as /objects/UMySettings/Intensity" + Messages.Suggest(Name, Names));
	}
	return bKnown;
}

void FRunAssignmentReader::CheckValue(const FStudyAssignment& Assignment, const FJsonValue& At)
{
	if (Assignment.Name == "precision")
	{
		CheckIsOneOf(At, Assignment.Value, {"float", "double"}, "precision", Messages);
	}
	else if (Assignment.Name == "storage")
	{
		CheckIsOneOf(At, Assignment.Value, {"native", "float32", "float64"}, "storage", Messages);
	}
	else if (FindSettingField(Assignment.Name) != nullptr)
	{
		FConfig Scratch;
		std::vector<FDiagnostic> Found;
		AddSettingArgument(Scratch, Assignment.Name + "=" + Assignment.Value, Found);
		for (FDiagnostic& Diagnostic : Found)
		{
			Diagnostic.File = File;
			Diagnostic.Line = At.Line;
			Diagnostic.Column = At.Column;
			Diagnostic.Where = At.Pointer;
			Diagnostics.push_back(Diagnostic);
		}
	}
	else if (!Contains(Special, Assignment.Name) && !IsConfigPlace(Assignment.Name))
	{
		CheckVariable({Assignment.Name, Assignment.Value, PlaceOf(At)}, Messages);
	}
}

std::optional<FStudyAssignment> FRunAssignmentReader::Read(
	const std::string& Name, const FJsonValue& NameAt, const FJsonValue& Value)
{
	const bool bKnown = CheckName(Name, NameAt);
	const std::optional<std::string> Text = bKnown ? ReadValueText(Value, Messages) : std::nullopt;
	if (!Text)
	{
		return std::nullopt;
	}
	const FStudyAssignment Assignment{Name, *Text, PlaceOf(Value)};
	CheckValue(Assignment, Value);
	return Assignment;
}

} // namespace Drydock
