// Formats the table of settings as text and as JSON.
#include "Config/SettingList.h"

#include "Config/ConsoleVariableText.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <cctype>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr size_t Width = 80;

std::string FormatBound(double Bound)
{
	return SettingToText(*FindSettingField("BloomIntensity"), {ESettingType::Float, {Bound}});
}

/** The type of a setting, with the class of an object. */
std::string FormatType(const FSettingField& Field)
{
	return Field.Type == ESettingType::Object ? std::string("path of a ") + Field.ObjectClass : ToString(Field.Type);
}

std::string FormatSetting(const FSettingField& Field)
{
	std::string Facts =
		std::string(Field.Name) + ": " + FormatType(Field) + " = " + SettingToText(Field, Field.Default);
	for (const std::string& Fact :
		{FormatSettingRange(Field), std::string(Field.Unit), std::string(ToString(Field.Blend))})
	{
		Facts += Fact.empty() ? "" : ", " + Fact;
	}
	const std::string Values = Field.EnumNames.Num() > 0 ? " One of " + JoinText(Field.EnumNames) + "." : "";
	return WrapText(Facts, Width, "      ", "  ") + WrapText(Field.Doc + Values, Width, "    ", "    ");
}

void WriteBound(FJsonWriter& Writer, const char* Key, double Bound)
{
	Writer.Key(Key).Raw(std::isfinite(Bound) ? FormatBound(Bound) : "null");
}

void WriteSetting(FJsonWriter& Writer, const FSettingField& Field)
{
	Writer.BeginObject(true);
	Writer.Members({{"name", Field.Name}, {"override", Field.OverrideName}, {"type", ToString(Field.Type)}});
	Writer.Key("default").Raw(SettingToJson(Field, Field.Default));
	Writer.Member("range", FormatSettingRange(Field));
	WriteBound(Writer, "min", Field.Range.ClampMin);
	WriteBound(Writer, "max", Field.Range.ClampMax);
	Writer.Members(
		{{"unit", Field.Unit}, {"blend", ToString(Field.Blend)}, {"category", Field.Category}, {"doc", Field.Doc}});
	if (Field.EnumNames.Num() > 0)
	{
		Writer.Member("values", Field.EnumNames);
	}
	if (Field.Type == ESettingType::Object)
	{
		Writer.Member("class", Field.ObjectClass);
	}
	Writer.EndObject();
}

} // namespace

std::vector<const FSettingField*> FindSettingFields(const std::string& Pattern)
{
	const bool bWildcards = Pattern.find_first_of("*?") != std::string::npos;
	std::vector<const FSettingField*> Found;
	for (const FSettingField& Field : GetSettingFields())
	{
		const bool bMatches = bWildcards ? FString(Field.Name).MatchesWildcard(FString(Pattern.c_str()))
										 : ToLowerCase(Field.Name).find(ToLowerCase(Pattern)) != std::string::npos;
		if (bMatches)
		{
			Found.push_back(&Field);
		}
	}
	return Found;
}

std::string FormatSettingRange(const FSettingField& Field)
{
	const FSettingRange& Range = Field.Range;
	if (!std::isfinite(Range.ClampMin) && !std::isfinite(Range.ClampMax))
	{
		return "";
	}
	return std::isfinite(Range.ClampMax) ? FormatBound(Range.ClampMin) + " .. " + FormatBound(Range.ClampMax)
										 : ">= " + FormatBound(Range.ClampMin);
}

std::string FormatSettings(const std::vector<const FSettingField*>& Fields)
{
	std::string Text;
	std::string Category;
	for (const FSettingField* Field : Fields)
	{
		if (Field->Category != Category)
		{
			Category = Field->Category;
			Text += (Text.empty() ? "" : "\n") + Category + "\n";
		}
		Text += FormatSetting(*Field);
	}
	return Text;
}

std::string FormatSettingsJson(const std::vector<const FSettingField*>& Fields)
{
	FJsonWriter Writer('[');
	for (const FSettingField* Field : Fields)
	{
		WriteSetting(Writer, *Field);
	}
	return Writer.GetText();
}

} // namespace Drydock
