// Writes names into the schema: texts of keys, and the definition of console variables.
#include "Config/ConfigSchemaNames.h"

#include "HAL/ConsoleVariableTools.h"
#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

/** The names that an axis of a study may have. */
std::vector<std::string> GetAxisNames()
{
	std::vector<std::string> Names = {"algorithm", "sigma", "input", "storage", "precision", "resolution"};
	const std::vector<FSettingField>& Fields = GetSettingFields();
	std::transform(Fields.begin(), Fields.begin() + static_cast<std::ptrdiff_t>(GetNumTableSettings()),
		std::back_inserter(Names), [](const FSettingField& Field) { return Field.Name; });
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		Names.emplace_back(*Info.Name);
	}
	return Names;
}

/** Texts of which one is meant, or of an open list any other. */
void WriteTexts(FJsonWriter& Writer, const std::vector<std::string>& Texts, bool bOpen)
{
	if (!bOpen)
	{
		WriteType(Writer, "string");
		WriteEnum(Writer, Texts);
		return;
	}
	Writer.Key("anyOf").BeginArray();
	Writer.BeginObject();
	WriteEnum(Writer, Texts);
	Writer.EndObject();
	Writer.Object({TypeOf("string")});
	Writer.EndArray();
}

} // namespace

FJsonWriter::FMember ReferTo(const std::string& Definition)
{
	return {"$ref", "#/definitions/" + Definition};
}

FJsonWriter::FMember TypeOf(const char* Type)
{
	return {"type", Type};
}

void WriteReference(FJsonWriter& Writer, const std::string& Definition)
{
	Writer.Members({ReferTo(Definition)});
}

void WriteType(FJsonWriter& Writer, const char* Type)
{
	Writer.Members({TypeOf(Type)});
}

void WriteEnum(FJsonWriter& Writer, const std::vector<std::string>& Texts)
{
	Writer.Member("enum", Texts);
}

bool WriteKnownNames(FJsonWriter& Writer, const FConfigKey& Key, const FSchemaNames& Names)
{
	const std::map<std::string, std::pair<const std::vector<std::string>*, bool>> Closed = {
		{"extension.type", {&Names.Extensions, false}}, {"extension.pass", {&Names.Hooks, true}},
		{"pass.type", {&Names.Passes, false}}, {"pass.at", {&Names.Hooks, true}},
		{"budget.metric", {&Names.Metrics, true}}, {"study.metrics", {&Names.Metrics, true}}};
	const std::string Place = std::string(Key.Object) + "." + Key.Name;
	const auto Found = Closed.find(Place);
	if (Place == "axis.name")
	{
		WriteTexts(Writer, GetAxisNames(), true);
		return true;
	}
	if (Place == "study.measure")
	{
		WriteTexts(Writer, {"final", "sceneLinear", "toonShadow"}, true);
		return true;
	}
	if (Found == Closed.end() || Found->second.first->empty())
	{
		return false;
	}
	const auto& [Texts, bClosed] = Found->second;
	if (Key.Kind == EConfigKind::StringArray)
	{
		WriteType(Writer, "array");
		Writer.Key("items").BeginObject();
		WriteTexts(Writer, *Texts, !bClosed);
		Writer.EndObject();
		return true;
	}
	WriteTexts(Writer, *Texts, !bClosed);
	return true;
}

void WriteVariables(FJsonWriter& Writer)
{
	const FJsonWriter::FMember Value("type", std::vector{"number", "string", "boolean"});
	Writer.Key("variables").BeginObject();
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		Writer.Key(*Info.Name).BeginObject(true);
		Writer.Member("description", *Info.Help);
		Writer.Members({Value});
		const bool bText = Info.Type == "FString";
		Writer.Key("default").Raw(bText ? FJsonWriter::Quote(*Info.Default) : std::string(*Info.Default));
		Writer.EndObject();
	}
	Writer.EndObject();
	Writer.Key("additionalProperties").Object({Value});
	Writer.EndObject();
}

} // namespace Drydock
