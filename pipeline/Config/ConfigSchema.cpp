// Writes the JSON schema (draft 7): objects from keys, settings, show flags.
#include "Config/ConfigSchema.h"

#include "Config/ConfigKeys.h"
#include "Config/ConfigSchemaNames.h"
#include "CurveKeys.h"
#include "PostProcessSettingsReflection.h"
#include "ShowFlags.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** {"type": "array", "items": <definition or type>} with the braces already open. */
void WriteItems(FJsonWriter& Writer, const char* Type, const std::string& Definition)
{
	Writer.Key("items").BeginObject(true);
	if (Definition.empty())
	{
		WriteType(Writer, Type);
	}
	else
	{
		WriteReference(Writer, Definition);
	}
	Writer.EndObject();
}

void WriteArray(FJsonWriter& Writer, const char* ItemType, const std::string& ItemDefinition, int Length)
{
	WriteType(Writer, "array");
	WriteItems(Writer, ItemType, ItemDefinition);
	if (Length > 0)
	{
		Writer.Member("minItems", Length);
		Writer.Member("maxItems", Length);
	}
}

void WriteMap(FJsonWriter& Writer, const char* Type)
{
	WriteType(Writer, "object");
	Writer.Key("additionalProperties").BeginObject(true);
	WriteType(Writer, Type);
	Writer.EndObject();
}

void WriteKind(FJsonWriter& Writer, const FConfigKey& Key, const std::string& Of)
{
	switch (Key.Kind)
	{
	case EConfigKind::String:
		WriteType(Writer, "string");
		if (!Of.empty())
		{
			WriteEnum(Writer, SplitText(Of, '|'));
		}
		break;
	case EConfigKind::Number:
		WriteType(Writer, "number");
		break;
	case EConfigKind::Bool:
		WriteType(Writer, "boolean");
		break;
	case EConfigKind::Vector3:
		WriteReference(Writer, "vector3");
		break;
	case EConfigKind::Rotator:
		WriteReference(Writer, "rotator");
		break;
	case EConfigKind::NumberArray:
		WriteArray(Writer, "number", "", Key.Length);
		break;
	case EConfigKind::StringArray:
		WriteType(Writer, "array");
		Writer.Key("items").BeginObject(Of.empty());
		WriteType(Writer, "string");
		if (!Of.empty())
		{
			WriteEnum(Writer, SplitText(Of, '|'));
		}
		Writer.EndObject();
		break;
	case EConfigKind::Vector3Array:
		WriteArray(Writer, "", "vector3", 0);
		break;
	case EConfigKind::Object:
		WriteReference(Writer, Of);
		break;
	case EConfigKind::ObjectArray:
		WriteArray(Writer, "", Of, 0);
		break;
	case EConfigKind::StringMap:
		WriteMap(Writer, "string");
		break;
	case EConfigKind::NumberMap:
		WriteMap(Writer, "number");
		break;
	case EConfigKind::Padding:
		Writer.Key("anyOf").BeginArray();
		Writer.BeginObject(true);
		WriteType(Writer, "number");
		Writer.EndObject();
		Writer.BeginObject(true);
		WriteArray(Writer, "number", "", 4);
		Writer.EndObject();
		Writer.BeginObject(true);
		WriteReference(Writer, Of);
		Writer.EndObject();
		Writer.EndArray();
		break;
	case EConfigKind::Settings:
		WriteReference(Writer, "Settings");
		break;
	case EConfigKind::ShowFlags:
		WriteReference(Writer, "showFlags");
		break;
	case EConfigKind::Variables:
		WriteReference(Writer, "variables");
		break;
	case EConfigKind::Anything:
		break;
	}
}

void WriteKey(FJsonWriter& Writer, const FConfigKey& Key, const FSchemaNames& Names)
{
	const std::string Of = Key.Of;
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
		Writer.BeginObject(true);
		WriteEnum(Writer, {Of.substr(Equals + 1)});
		Writer.EndObject();
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
		Writer.Key("required").BeginArray(true);
		for (const std::string& Name : Required)
		{
			Writer.Value(Name);
		}
		Writer.EndArray();
	}
	if (Open != nullptr && Open->Kind == EConfigKind::Object)
	{
		Writer.Key("additionalProperties").BeginObject(true);
		WriteReference(Writer, Open->Of);
		Writer.EndObject();
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

/** Keys, the path of an asset, or null. */
void WriteCurve(FJsonWriter& Writer)
{
	Writer.Key("type").BeginArray(true);
	Writer.Value("object");
	Writer.Value("string");
	Writer.Value("null");
	Writer.EndArray();
	Writer.Key("properties").BeginObject();
	Writer.Key("keys").BeginObject();
	Writer.Member("description", "[time, value] each, times ascending.");
	WriteType(Writer, "array");
	Writer.Member("minItems", 1);
	Writer.Key("items").BeginObject();
	WriteArray(Writer, "number", "", 2);
	Writer.EndObject();
	Writer.EndObject();
	Writer.Key("interp").BeginObject();
	WriteEnum(Writer, GetCurveInterpNames());
	Writer.EndObject();
	Writer.EndObject();
	Writer.Key("required").BeginArray(true);
	Writer.Value("keys");
	Writer.EndArray();
	Writer.Member("additionalProperties", false);
}

void WriteSettingSchema(FJsonWriter& Writer, const FSettingField& Field)
{
	Writer.Key(Field.Name).BeginObject();
	Writer.Member("description", DescribeSetting(Field));
	switch (Field.Type)
	{
	case ESettingType::Float:
		WriteType(Writer, "number");
		break;
	case ESettingType::Int:
		WriteType(Writer, "integer");
		break;
	case ESettingType::Bool:
		WriteType(Writer, "boolean");
		break;
	case ESettingType::Color:
		WriteReference(Writer, "color");
		break;
	case ESettingType::Vector2:
		WriteReference(Writer, "vector2");
		break;
	case ESettingType::Vector4:
		WriteReference(Writer, "vector4");
		break;
	case ESettingType::Object:
		if (std::string_view(Field.ObjectClass) == "CurveFloat")
		{
			WriteCurve(Writer);
			break;
		}
		Writer.Key("type").BeginArray(true);
		Writer.Value("string");
		Writer.Value("null");
		Writer.EndArray();
		break;
	case ESettingType::ColorArray:
		WriteArray(Writer, "", "color", MaxSettingComponents / 4);
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
	}
	Writer.Key("default").Raw(SettingToJson(Field, Field.Default));
	Writer.EndObject();
}

void WriteBlendables(FJsonWriter& Writer)
{
	Writer.Key("WeightedBlendables").BeginObject();
	Writer.Member("description", "Materials and other objects that are blended in by weight. Not built yet.");
	WriteType(Writer, "array");
	Writer.Key("items").BeginObject();
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	Writer.Key("Object").BeginObject(true);
	Writer.Key("type").BeginArray(true);
	Writer.Value("string");
	Writer.Value("null");
	Writer.EndArray();
	Writer.EndObject();
	Writer.Key("Weight").BeginObject(true);
	WriteType(Writer, "number");
	Writer.EndObject();
	Writer.EndObject();
	Writer.Member("additionalProperties", false);
	Writer.EndObject();
	Writer.EndObject();
}

void WriteSettingsSchema(FJsonWriter& Writer)
{
	Writer.Key("Settings").BeginObject();
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	const std::vector<FSettingField> Fields(
		GetSettingFields().begin(), GetSettingFields().begin() + static_cast<ptrdiff_t>(GetNumTableSettings()));
	for (const FSettingField& Field : Fields)
	{
		WriteSettingSchema(Writer, Field);
	}
	WriteBlendables(Writer);
	for (const FSettingField& Field : Fields)
	{
		Writer.Key(Field.OverrideName).BeginObject(true);
		WriteType(Writer, "boolean");
		Writer.EndObject();
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
		Writer.Key(Info.Name).BeginObject(true);
		Writer.Member("description", Info.Doc);
		WriteType(Writer, "boolean");
		Writer.Member("default", Info.bInGame);
		Writer.EndObject();
	}
	Writer.EndObject();
	Writer.Member("additionalProperties", false);
	Writer.EndObject();
}

/** A row of numbers, or an object of named ones. Least: how many the array must have. */
void WriteNumbers(FJsonWriter& Writer, const std::string& Name, const std::string& Components, int Least)
{
	Writer.Key(Name).BeginObject();
	Writer.Key("anyOf").BeginArray();
	Writer.BeginObject(true);
	WriteType(Writer, "array");
	WriteItems(Writer, "number", "");
	Writer.Member("minItems", Least);
	Writer.Member("maxItems", static_cast<int>(Components.size()));
	Writer.EndObject();
	Writer.BeginObject(true);
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	for (const char Component : Components)
	{
		Writer.Key(std::string(1, Component)).BeginObject();
		WriteType(Writer, "number");
		Writer.EndObject();
	}
	Writer.EndObject();
	Writer.Key("required").BeginArray();
	for (int Index = 0; Index < Least; ++Index)
	{
		Writer.Value(std::string(1, Components[static_cast<size_t>(Index)]));
	}
	Writer.EndArray();
	Writer.Member("additionalProperties", false);
	Writer.EndObject();
	Writer.EndArray();
	Writer.EndObject();
}

/** A vector, or angles by name. */
void WriteRotator(FJsonWriter& Writer)
{
	Writer.Key("rotator").BeginObject();
	Writer.Key("anyOf").BeginArray();
	Writer.BeginObject(true);
	WriteReference(Writer, "vector3");
	Writer.EndObject();
	Writer.BeginObject(true);
	WriteType(Writer, "object");
	Writer.Key("properties").BeginObject();
	for (const char* const Angle : {"Pitch", "Yaw", "Roll"})
	{
		Writer.Key(Angle).BeginObject();
		WriteType(Writer, "number");
		Writer.EndObject();
	}
	Writer.EndObject();
	Writer.Member("minProperties", 1);
	Writer.Member("additionalProperties", false);
	Writer.EndObject();
	Writer.EndArray();
	Writer.EndObject();
}

} // namespace

std::string MakeConfigSchema(const FSchemaNames& Names)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("$schema", "http://json-schema.org/draft-07/schema#");
	Writer.Member("title", "drydock config");
	WriteObject(Writer, "", Names);
	Writer.Key("definitions").BeginObject();
	std::vector<std::string> Written = {""};
	for (const FConfigKey& Key : GetConfigKeys())
	{
		if (std::find(Written.begin(), Written.end(), Key.Object) == Written.end())
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
	WriteNumbers(Writer, "vector2", "XY", 2);
	WriteNumbers(Writer, "vector3", "XYZ", 3);
	WriteRotator(Writer);
	WriteNumbers(Writer, "vector4", "XYZW", 4);
	WriteNumbers(Writer, "color", "RGBA", 3);
	Writer.EndObject();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
