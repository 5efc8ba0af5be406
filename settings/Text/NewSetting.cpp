// Reads a setting as it was thought of on the command line, or takes it from the table.
#include "NewSetting.h"

#include "PostProcessSettingsTextScan.h"
#include "PostProcessSettingsTextValue.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

template<typename T>
std::string FormatNumber(T Number)
{
	const std::string Text = FormatShortest(Number);
	return Text.find_first_of(".e") == std::string::npos ? Text + ".0" : Text;
}

std::string FormatFloat(double Number)
{
	return FormatNumber(static_cast<float>(Number)) + "f";
}

/** "FLinearColor(1.0f, 1.0f, 1.0f, 1.0f)" */
std::string FormatVector(const std::string& Type, const double* Components, int Num)
{
	std::string Text;
	for (int Index = 0; Index < Num; ++Index)
	{
		Text += std::string(Index == 0 ? "" : ", ") +
				(Type == "FLinearColor" ? FormatFloat(Components[Index]) : FormatNumber(Components[Index]));
	}
	return Type + "(" + Text + ")";
}

std::string FormatDefault(const FSettingField& Field, const std::string& Type)
{
	const FSettingValue& Value = Field.Default;
	switch (Field.Type)
	{
	case ESettingType::Float:
		return FormatFloat(Value.Components[0]);
	case ESettingType::Object:
		return "nullptr";
	case ESettingType::Color:
	case ESettingType::Vector2:
	case ESettingType::Vector4:
		return FormatVector(Type, Value.Components, Field.GetNumComponents());
	case ESettingType::ColorArray:
	{
		std::string Text;
		for (int Index = 0; Index < Field.GetNumComponents(); Index += 4)
		{
			Text += std::string(Index == 0 ? "" : ", ") + FormatVector(Type, Value.Components + Index, 4);
		}
		return "{" + Text + "}";
	}
	case ESettingType::Enum:
	{
		const std::string Name = SettingToText(Field, Value);
		return Name.find('_') != std::string::npos ? Name : Type.substr(0, Type.find('>')) + "::" + Name;
	}
	default:
		return SettingToText(Field, Value);
	}
}

std::string GetCppType(const FSettingField& Field)
{
	constexpr const char* Types[] = {
		"float", "bool", "int32", "E", "FLinearColor", "FVector2D", "FVector4", "TObjectPtr<class U", "FLinearColor"};
	return std::string(Types[size_t(Field.Type)]) + (Field.Type == ESettingType::Enum ? Field.Name
														: Field.Type == ESettingType::Object
															? std::string(Field.ObjectClass) + ">"
															: "");
}

/** A bound in the table's words: 0, 0.02. */
std::string FormatBound(double Bound)
{
	const std::string Text = FormatNumber(Bound);
	return Text.size() > 2 && Text.compare(Text.size() - 2, 2, ".0") == 0 ? Text.substr(0, Text.size() - 2) : Text;
}

std::string FormatRange(const FSettingRange& Range)
{
	return !std::isfinite(Range.ClampMin) ? "Anything"
		   : std::isfinite(Range.ClampMax)
			   ? "Between(" + FormatBound(Range.ClampMin) + ", " + FormatBound(Range.ClampMax) + ")"
			   : "AtLeast(" + FormatBound(Range.ClampMin) + ", " + FormatBound(Range.UIMax) + ")";
}

} // namespace

FNewSetting DescribeNewSetting(const FSettingField& Field)
{
	FNewSetting Setting;
	Setting.Name = Field.Name;
	Setting.Type = GetCppType(Field);
	Setting.Default = FormatDefault(Field, Setting.Type);
	Setting.Range = FormatRange(Field.Range);
	Setting.Unit = Field.Unit;
	Setting.ClampMin = std::isfinite(Field.Range.ClampMin) ? FormatNumber(Field.Range.ClampMin) : "";
	Setting.ClampMax = std::isfinite(Field.Range.ClampMax) ? FormatNumber(Field.Range.ClampMax) : "";
	Setting.UIMax = std::isfinite(Field.Range.UIMax) && Setting.ClampMax.empty() ? FormatNumber(Field.Range.UIMax) : "";
	Setting.Category = Field.Category;
	Setting.Doc = Field.Doc;
	Setting.Blend = Field.Blend;
	Setting.OverrideName = Field.OverrideName;
	Setting.NumElements = GetNumTextElements(Field);
	Setting.bInTable = true;
	return Setting;
}

const std::vector<std::string>& GetNewSettingTypes()
{
	static const std::vector<std::string> Types = {"float", "bool", "int32", "FLinearColor", "FVector2D", "FVector4"};
	return Types;
}

std::optional<FNewSetting> MakeNewSetting(
	const std::string& Name, const std::string& Type, const std::string& Default, std::string& OutError)
{
	static const std::vector<std::pair<std::string, std::string>> ShortNames = {
		{"int", "int32"}, {"color", "FLinearColor"}, {"vector2", "FVector2D"}, {"vector4", "FVector4"}};
	FNewSetting Setting;
	Setting.Name = Name;
	Setting.OverrideName = "bOverride_" + Name;
	Setting.Doc = "Effect of " + Name + ".";
	Setting.Type = Type;
	for (const auto& [Short, Long] : ShortNames)
	{
		Setting.Type = Type == Short ? Long : Setting.Type;
	}
	const std::vector<std::string>& Types = GetNewSettingTypes();
	if (!IsEngineTextName(Name))
	{
		OutError = "\"" + Name + "\" is not a name: use letters, digits and underscores, and no digit first";
		return std::nullopt;
	}
	if (std::ranges::find(Types, Setting.Type) == Types.end())
	{
		OutError = "there is no type " + Type + "; there are float, bool, int, color, vector2, vector4";
		return std::nullopt;
	}
	// Fields of the same types know how values are read and written.
	const auto Same = std::ranges::find_if(GetSettingFields(), [&](const FSettingField& Field)
		{ return GetCppType(Field) == Setting.Type && GetNumTextElements(Field) == 1; });
	FSettingField Model = *Same;
	Model.Default = FSettingValue{Model.Type};
	if (!Default.empty() && !SettingFromText(Model, Default, Model.Default, OutError))
	{
		OutError = "the default " + Default + " is not of type " + Type + ": " + OutError;
		return std::nullopt;
	}
	Setting.Default = FormatDefault(Model, Setting.Type);
	Setting.Blend = Setting.Type == "bool" || Setting.Type == "int32" ? ESettingBlend::Set : ESettingBlend::Lerp;
	Setting.Category = Name.starts_with("Bloom") ? "Lens|Bloom" : Name.starts_with("Film") ? "Film" : "Lens";
	return Setting;
}

std::string MakeTableLine(const FNewSetting& Setting)
{
	return "DRYDOCK_SETTING(" + Setting.Type + ", " + Setting.Name + ", " + Setting.Default + ", " + Setting.Range +
		   ", \"" + Setting.Unit + "\", \"" + Setting.Category + "\", " + ToString(Setting.Blend) + ", \"" +
		   Setting.Doc + "\")";
}

} // namespace Drydock
