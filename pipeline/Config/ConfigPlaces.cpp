// Walks a config's JSON from member to member.
#include "Config/ConfigPlaces.h"

#include "Text/ConfigErrors.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** The member or element, and null where there is none. */
const FJsonValue* FindStep(const FJsonValue& Value, const std::string& Step)
{
	if (Value.Type == EJsonType::Array)
	{
		const auto Found = std::find_if(Value.Elements.begin(), Value.Elements.end(),
			[&](const FJsonValue& Element) { return Element.Pointer == Value.Pointer + "/" + Step; });
		return Found == Value.Elements.end() ? nullptr : &*Found;
	}
	return Value.Find(Step);
}

/** Calls Do with each step of "/a/b/c". */
template<typename TDo>
void ForEachStep(const std::string& Place, const TDo& Do)
{
	for (size_t Begin = 1, End = 0; End < Place.size(); Begin = End + 1)
	{
		End = std::min(Place.find('/', Begin), Place.size());
		Do(Place.substr(Begin, End - Begin));
	}
}

} // namespace

bool IsConfigPlace(const std::string& Place)
{
	return Place.starts_with("/objects/") || Place.starts_with("/passes/") || Place.starts_with("/extensions/");
}

std::optional<std::string> FindPlaceText(const FJsonValue& Root, const std::string& Place)
{
	const FJsonValue* Value = &Root;
	ForEachStep(Place, [&](const std::string& Step) { Value = Value ? FindStep(*Value, Step) : nullptr; });
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
	ForEachStep(Place,
		[&](const std::string& Step)
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
		});
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
	*Value = std::move(Given);
}

} // namespace Drydock
