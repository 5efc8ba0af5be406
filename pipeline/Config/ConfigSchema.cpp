// Writes the JSON schema (draft 7): objects from keys, settings, show flags.
#include "Config/ConfigSchema.h"

#include "Config/ConfigKeys.h"
#include "Config/ConfigSchemaNames.h"
#include "PostProcessSettingsReflection.h"
#include "ShowFlags.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <cmath>
#include <map>

namespace Drydock
{

namespace
{

/** The definitions of vectors, rotators, colours, curves and blendables, as text. */
constexpr const char* Definitions =
#include "ConfigSchema.txt"
#include "RangeTools.h"
	;

/** Items: the member that describes an item. */
void WriteArray(FJsonWriter& Writer, const FJsonWriter::FMember& Items, int Length)
{
	WriteType(Writer, "array");
	Writer.Key("items").Object({Items});
	if (Length > 0)
	{
		Writer.Members({{"minItems", Length}, {"maxItems", Length}});
	}
}

void WriteMap(FJsonWriter& Writer, const char* Type)
{
	WriteType(Writer, "object");
	Writer.Key("additionalProperties").Object({TypeOf(Type)});
}

/** A text; one of these, where there are any. */
void WriteText(FJsonWriter& Writer, const std::string& Alternatives)
{
	WriteType(Writer, "string");
	if (!Alternatives.empty())
	{
		Writer.Member("enum", SplitText(Alternatives, '|'));
	}
}

void WriteKind(FJsonWriter& Writer, const FConfigKey& Key, const std::string& Of)
{
	static const std::map<EConfigKind, const char*> Defined = {{EConfigKind::Vector3, "vector3"},
		{EConfigKind::Rotator, "rotator"}, {EConfigKind::Settings, "Settings"}, {EConfigKind::ShowFlags, "showFlags"},
		{EConfigKind::Variables, "variables"}, {EConfigKind::Folders, "folders"}};
	switch (Key.Kind)
	{
	case EConfigKind::String:
		WriteText(Writer, Of);
		break;
	case EConfigKind::Number:
		WriteType(Writer, "number");
		break;
	case EConfigKind::Bool:
		WriteType(Writer, "boolean");
		break;
	case EConfigKind::NumberArray:
		WriteArray(Writer, TypeOf("number"), Key.Length);
		break;
	case EConfigKind::StringArray:
		WriteType(Writer, "array");
		Writer.Key("items").BeginObject(Of.empty());
		WriteText(Writer, Of);
		Writer.EndObject();
		break;
	case EConfigKind::Vector3Array:
		WriteArray(Writer, ReferTo("vector3"), 0);
		break;
	case EConfigKind::Object:
		WriteReference(Writer, Of);
		break;
	case EConfigKind::ObjectArray:
		WriteArray(Writer, ReferTo(Of), 0);
		break;
	case EConfigKind::StringMap:
		WriteMap(Writer, "string");
		break;
	case EConfigKind::NumberMap:
		WriteMap(Writer, "number");
		break;
	case EConfigKind::Padding:
		Writer.Key("anyOf").BeginArray();
		Writer.Object({TypeOf("number")});
		Writer.BeginObject(true);
		WriteArray(Writer, TypeOf("number"), 4);
		Writer.EndObject();
		Writer.Object({ReferTo(Of)});
		Writer.EndArray();
		break;
	case EConfigKind::Anything:
		break;
	default:
		WriteReference(Writer, Defined.at(Key.Kind));
	}
}

void WriteKey(FJsonWriter& Writer, const FConfigKey& Key, const FSchemaNames& Names)
{
	const std::string& Of = Key.Of;
	const size_t Equals = Of.find('=');
	Writer.Key(Key.Name).BeginObject();
	Writer.Member("description", Key.Doc);
	const bool bNames = WriteKnownNames(Writer, Key, Names);
	if (!bNames && Equals == std::string::npos)
	{
		WriteKind(Writer, Key, Of);
	}
	else if (!bNames)
	{
		Writer.Key("anyOf").BeginArray();
		Writer.BeginObject(true);
		WriteKind(Writer, Key, Of.substr(0, Equals));
		Writer.EndObject();
		Writer.Object({{"enum", std::vector{Of.substr(Equals + 1)}}});
		Writer.EndArray();
	}
	Writer.EndObject();
}

/** Members of one kind of object, inside an object that has been begun. */
void WriteObject(FJsonWriter& Writer, const std::string& Object, const FSchemaNames& Names)
{
	std::vector<std::string> Required;
	const FConfigKey* Open = nullptr; // of any further key
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	for (const FConfigKey& Key : GetConfigKeys())
	{
		if (Object != Key.Object)
		{
			continue;
		}
		if (std::string(Key.Name) == "*")
		{
			Open = &Key;
			continue;
		}
		WriteKey(Writer, Key, Names);
		if (Key.bRequired)
		{
			Required.emplace_back(Key.Name);
		}
	}
	Writer.EndObject();
	if (!Required.empty())
	{
		Writer.Member("required", Required);
	}
	if (Open != nullptr && Open->Kind == EConfigKind::Object)
	{
		Writer.Key("additionalProperties").Object({ReferTo(Open->Of)});
		return;
	}
	Writer.Member("additionalProperties", Open != nullptr);
	if (Names.WriteTypeRules != nullptr && (Object == "extension" || Object == "pass"))
	{
		Writer.Key("allOf").BeginArray();
		Names.WriteTypeRules(Writer, Object);
		Writer.EndArray();
	}
}

std::string DescribeSetting(const FSettingField& Field)
{
	std::string Text = Field.Doc;
	if (Field.Unit[0] != '\0')
	{
		Text += std::string(" Unit: ") + Field.Unit + ".";
	}
	if (std::isfinite(Field.Range.ClampMin))
	{
		const FSettingValue Min{Field.Type, {Field.Range.ClampMin}};
		const FSettingValue Max{Field.Type, {Field.Range.ClampMax}};
		Text += std::isfinite(Field.Range.ClampMax)
					? " Range: " + SettingToText(Field, Min) + " to " + SettingToText(Field, Max) + "."
					: " At least " + SettingToText(Field, Min) + ".";
	}
	return Text;
}

void WriteSettingSchema(FJsonWriter& Writer, const FSettingField& Field)
{
	static const std::map<ESettingType, FJsonWriter::FMember> Plain = {{ESettingType::Float, TypeOf("number")},
		{ESettingType::Int, TypeOf("integer")}, {ESettingType::Bool, TypeOf("boolean")},
		{ESettingType::Color, ReferTo("color")}, {ESettingType::Vector2, ReferTo("vector2")},
		{ESettingType::Vector4, ReferTo("vector4")}};
	Writer.Key(Field.Name).BeginObject();
	Writer.Member("description", DescribeSetting(Field));
	switch (Field.Type)
	{
	case ESettingType::Object:
		if (std::string_view(Field.ObjectClass) == "CurveFloat")
		{
			WriteReference(Writer, "curve");
			break;
		}
		Writer.Member("type", {"string", "null"});
		break;
	case ESettingType::ColorArray:
		WriteArray(Writer, ReferTo("color"), MaxSettingComponents / 4);
		break;
	case ESettingType::Enum:
		Writer.Key("enum").BeginArray(true);
		for (const char* Name : Field.EnumNames)
		{
			Writer.Value(Name);
		}
		for (int32 Number = 0; Number < Field.EnumNames.Num(); ++Number)
		{
			Writer.Value(Number);
		}
		Writer.EndArray();
		break;
	default:
		Writer.Members({Plain.at(Field.Type)});
	}
	Writer.Key("default").Raw(SettingToJson(Field, Field.Default));
	Writer.EndObject();
}

void WriteSettingsSchema(FJsonWriter& Writer)
{
	Writer.Key("Settings").BeginObject();
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (const FSettingField& Field : Fields)
	{
		WriteSettingSchema(Writer, Field);
	}
	Writer.Key("WeightedBlendables").Object({ReferTo("blendables")});
	for (const FSettingField& Field : Fields)
	{
		Writer.Key(Field.OverrideName).Object({TypeOf("boolean")});
	}
	Writer.EndObject();
	Writer.Member("additionalProperties", true); // plugins bring settings
	Writer.EndObject();
}

void WriteShowFlags(FJsonWriter& Writer)
{
	Writer.Key("showFlags").BeginObject();
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	for (const FShowFlagInfo& Info : GetShowFlagInfos())
	{
		Writer.Key(Info.Name).Object({{"description", Info.Doc}, TypeOf("boolean"), {"default", Info.bInGame}});
	}
	Writer.EndObject();
	Writer.Member("additionalProperties", false);
	Writer.EndObject();
}

} // namespace

std::string MakeConfigSchema(const FSchemaNames& Names)
{
	FJsonWriter Writer('{');
	Writer.Member("$schema", "http://json-schema.org/draft-07/schema#");
	Writer.Member("title", "drydock config");
	WriteObject(Writer, "", Names);
	Writer.Key("definitions").BeginObject();
	std::vector<std::string> Written = {""};
	for (const FConfigKey& Key : GetConfigKeys())
	{
		if (!Contains(Written, Key.Object))
		{
			Written.emplace_back(Key.Object);
			Writer.Key(Key.Object).BeginObject();
			WriteObject(Writer, Key.Object, Names);
			Writer.EndObject();
		}
	}
	WriteSettingsSchema(Writer);
	WriteShowFlags(Writer);
	WriteVariables(Writer);
	Writer.Raw(Definitions);
	return Writer.GetText();
}

} // namespace Drydock
