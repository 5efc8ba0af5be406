// Walks a config's JSON from member to member.
#include "Config/ConfigPlaces.h"

#include "RangeTools.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

/** The member or element, and null where there is none. */
const FJsonValue* FindStep(const FJsonValue& Value, const std::string& Step)
{
	if (Value.Type == EJsonType::Array)
	{
		return FindItem(Value.Elements, Value.Pointer + "/" + Step, &FJsonValue::Pointer);
	}
	return Value.Find(Step);
}

/** The steps of "/a/b/c". */
std::vector<std::string> SplitPlace(const std::string& Place)
{
	return SplitText(Place.substr(1) + "/", '/');
}

} // namespace

bool IsConfigPlace(const std::string& Place)
{
	return Place.starts_with("/objects/") || Place.starts_with("/passes/") || Place.starts_with("/extensions/");
}

std::optional<std::string> FindPlaceText(const FJsonValue& Root, const std::string& Place)
{
	const FJsonValue* Value = &Root;
	for (const std::string& Step : SplitPlace(Place))
	{
		Value = Value ? FindStep(*Value, Step) : nullptr;
	}
	return Value == nullptr                   ? std::nullopt
		   : Value->Type == EJsonType::Number ? std::optional(NumberText(Value->Number))
		   : Value->Type == EJsonType::String ? std::optional(Value->String)
		   : Value->Type == EJsonType::Bool   ? std::optional<std::string>(Value->Bool ? "true" : "false")
											  : std::nullopt;
}

void SetConfigPlace(FJsonValue& Root, const std::string& Argument, const std::string& File)
{
	const size_t Equals = Argument.find('=');
	const std::string Place = Argument.substr(0, Equals), Text = Argument.substr(Equals + 1);
	FJsonValue* Value = &Root;
	for (const std::string& Step : SplitPlace(Place))
	{
		auto* Next = const_cast<FJsonValue*>(FindStep(*Value, Step)); // Value is not const
		if (Next == nullptr && (Value->Type == EJsonType::Array || (Value == &Root && Step != "objects")))
		{
			throw FError({.Code = ErrorUnknownValue,
							 .Message = "the config has no " + Value->Pointer + "/" + Step,
							 .File = File,
							 .Where = Place},
				ExitUsage);
		}
		if (Next == nullptr)
		{
			Value->Type = EJsonType::Object;
			Next = &Value->Members.emplace_back(FJsonMember{Step, {}}).Value;
			Next->Pointer = Value->Pointer + "/" + Step;
		}
		Value = Next;
	}
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	FJsonValue Given = ParseJson(Text, "", Faults, bSyntaxError);
	if (bSyntaxError || !Faults.empty())
	{
		Given = {};
		Given.Type = EJsonType::String;
		Given.String = Text;
	}
	Given.Pointer = Place;
	Given.Line = Value->Line; // messages point at the value that it replaces
	Given.Column = Value->Column;
	Given.KeyLine = Value->KeyLine;
	Given.KeyColumn = Value->KeyColumn;
	*Value = std::move(Given);
}

} // namespace Drydock
