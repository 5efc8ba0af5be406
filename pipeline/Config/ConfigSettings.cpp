// The "Settings" object of volumes and camera. The meaning of override bits is the engine's.
#include "Config/ConfigReader.h"

#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "SettingObjects.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

const std::string OverridePrefix = "bOverride_";

bool IsCurve(const FSettingField& Field)
{
	return std::string_view(Field.ObjectClass) == "CurveFloat";
}

std::string ExpectedText(const FSettingField& Field)
{
	switch (Field.Type)
	{
	case ESettingType::Bool:
		return "true or false";
	case ESettingType::Int:
		return "a whole number";
	case ESettingType::Float:
		return "a number";
	case ESettingType::Color:
		return "a colour: [R, G, B], [R, G, B, A] or {\"R\": .., \"G\": .., \"B\": .., \"A\": ..}";
	case ESettingType::Vector2:
		return "two numbers: [X, Y] or {\"X\": .., \"Y\": ..}";
	case ESettingType::Vector4:
		return "four numbers: [X, Y, Z, W] or {\"X\": .., \"Y\": .., \"Z\": .., \"W\": ..}";
	case ESettingType::Object:
		return (IsCurve(Field) ? "keys, {\"keys\": [[time, value], ...], \"interp\": \"linear\"}, or " : "") +
			   std::string("the path of a ") + Field.ObjectClass + ", such as \"/Game/Folder/Name.Name\", or null";
	case ESettingType::ColorArray:
		return "eight colours: [[R, G, B, A], ...]";
	case ESettingType::Enum:
		break;
	}
	return "one of " + JoinText(Field.EnumNames);
}

/** Components of a colour or vector, alpha 1 where it is omitted; false when Value is neither array nor object of them.
 */
bool ReadComponents(const FJsonValue& Value, const std::string& Names, double* OutComponents)
{
	const size_t NumGiven = Value.Type == EJsonType::Array ? Value.Elements.size() : Value.Members.size();
	const bool bAlphaOmitted = Names == "RGBA" && NumGiven == 3;
	if ((Value.Type != EJsonType::Array && Value.Type != EJsonType::Object) ||
		(NumGiven != Names.size() && !bAlphaOmitted))
	{
		return false;
	}
	for (size_t Index = 0; Index < NumGiven; ++Index)
	{
		const FJsonValue* Component =
			Value.Type == EJsonType::Array ? &Value.Elements[Index] : Value.Find(std::string(1, Names[Index]));
		if (Component == nullptr || Component->Type != EJsonType::Number)
		{
			return false;
		}
		OutComponents[Index] = Component->Number;
	}
	if (bAlphaOmitted)
	{
		OutComponents[3] = 1.0;
	}
	return true;
}

bool ReadColorArray(const FJsonValue& Value, FSettingValue& OutValue)
{
	bool bRead = Value.Type == EJsonType::Array && Value.Elements.size() == MaxSettingComponents / 4;
	for (size_t Index = 0; bRead && Index < Value.Elements.size(); ++Index)
	{
		bRead = ReadComponents(Value.Elements[Index], "RGBA", OutValue.Components + Index * 4);
	}
	return bRead;
}

/** A string in one of the forms of `--pp`. */
bool ReadText(const FSettingField& Field, const FJsonValue& Value, FSettingValue& OutValue)
{
	std::string Unused;
	return Value.Type == EJsonType::String && SettingFromText(Field, Value.String, OutValue, Unused);
}

bool ReadSettingValue(const FSettingField& Field, const FJsonValue& Value, FSettingValue& OutValue)
{
	OutValue.Type = Field.Type;
	switch (Field.Type)
	{
	case ESettingType::Bool:
		OutValue.Components[0] = Value.Bool ? 1.0 : 0.0;
		return Value.Type == EJsonType::Bool;
	case ESettingType::Float:
		OutValue.Components[0] = Value.Number;
		return Value.Type == EJsonType::Number;
	case ESettingType::Int:
		OutValue.Components[0] = Value.Number;
		return Value.Type == EJsonType::Number && Value.Number == std::floor(Value.Number) &&
			   std::fabs(Value.Number) < 2147483648.0;
	case ESettingType::Enum:
		OutValue.Components[0] = Value.Number;
		return ReadText(Field, Value, OutValue) ||
			   (Value.Type == EJsonType::Number && Value.Number == std::floor(Value.Number) && Value.Number >= 0.0 &&
				   Value.Number < Field.EnumNames.Num());
	case ESettingType::Object:
		return Value.Type == EJsonType::Null || ReadText(Field, Value, OutValue);
	case ESettingType::Color:
		return ReadComponents(Value, "RGBA", OutValue.Components);
	case ESettingType::Vector2:
		return ReadComponents(Value, "XY", OutValue.Components);
	case ESettingType::Vector4:
		return ReadComponents(Value, "XYZW", OutValue.Components);
	case ESettingType::ColorArray:
		return ReadColorArray(Value, OutValue);
	}
	return false;
}

/** Whether some number inside was not finite, and so reported already. */
bool ContainsInvalid(const FJsonValue& Value)
{
	return Value.Type == EJsonType::Invalid || std::ranges::any_of(Value.Elements, ContainsInvalid) ||
		   std::ranges::any_of(Value.Members, ContainsInvalid, &FJsonMember::Value);
}

/** JSON numbers are doubles; what float cannot hold would become infinite. */
bool FitsFloat(const FSettingField& Field, const FSettingValue& Value)
{
	const bool bFloat = Field.Type == ESettingType::Float || Field.Type == ESettingType::Color ||
						Field.Type == ESettingType::ColorArray;
	return !bFloat || std::all_of(std::begin(Value.Components), std::end(Value.Components),
						  [](double Component) { return std::isfinite(static_cast<float>(Component)); });
}

void ReadSetting(const std::string& Name, const FJsonValue& Value, FConfigSettings& Settings, FConfigMessages& Messages)
{
	const FSettingField* Field = FindSettingField(Name);
	if (Field == nullptr)
	{
		Messages.ErrorAtKey(ErrorUnknownSetting, Value, "unknown setting" + Messages.SuggestSetting(Name));
		return;
	}
	FSettingValue SettingValue;
	if (ContainsInvalid(Value))
	{
		return;
	}
	if (IsCurve(*Field) && Value.Type == EJsonType::Object)
	{
		const std::optional<std::string> Curve = ReadConfigCurve(Value, Name, Messages);
		if (!Curve)
		{
			return;
		}
		SettingValue = {ESettingType::Object, {}, Field->FindOrAddObject(*Curve)};
	}
	else if (!ReadSettingValue(*Field, Value, SettingValue))
	{
		const std::string Suggestion =
			Field->Type == ESettingType::Enum && Value.Type == EJsonType::String
				? Messages.Suggest(
					  Value.String, std::vector<std::string>(Field->EnumNames.begin(), Field->EnumNames.end()))
				: "";
		const EConfigError Code = Suggestion.empty() && Value.Type != EJsonType::String ? ErrorWrongType
								  : Field->Type == ESettingType::Enum                   ? ErrorUnknownValue
																						: ErrorWrongType;
		Messages.Error(Code, Value, Name + " must be " + ExpectedText(*Field) + Suggestion);
		return;
	}
	if (!FitsFloat(*Field, SettingValue))
	{
		Messages.Error(ErrorNumberNotFinite, Value, Name + " is a float, and the number is too large for it");
		return;
	}
	if (!Field->IsInRange(SettingValue))
	{
		FSettingValue Min{Field->Type, {Field->Range.ClampMin}};
		FSettingValue Max{Field->Type, {Field->Range.ClampMax}};
		const std::string Range = std::isinf(Field->Range.ClampMax)
									  ? "at least " + SettingToText(*Field, Min)
									  : SettingToText(*Field, Min) + " to " + SettingToText(*Field, Max);
		Messages.Warn(WarnOutOfRange, Value, Name + " is outside its range, " + Range + "; it is used as it is");
	}
	Field->Set(Settings.Settings, SettingValue);
	Field->SetOverridden(Settings.Settings, true);
	Settings.Places[Name] = {Value.KeyLine, Value.KeyColumn, Value.Pointer};
}

std::vector<std::string> GetOverrideNames()
{
	return ToVector<std::string>(GetSettingFields(), &FSettingField::OverrideName);
}

/** Override bits come after all values, whatever their order in the file. */
void ReadOverride(
	const std::string& Name, const FJsonValue& Value, FConfigSettings& Settings, FConfigMessages& Messages)
{
	const FSettingField* Field = FindSettingFieldByOverride(Name);
	const std::string Setting = Field == nullptr ? "" : Field->Name;
	if (Field == nullptr)
	{
		Messages.ErrorAtKey(
			ErrorUnknownSetting, Value, "unknown setting" + Messages.SuggestFrom(Name, GetOverrideNames));
	}
	else if (Value.Type != EJsonType::Bool)
	{
		Messages.Error(ErrorWrongType, Value, Name + " must be true or false");
	}
	else if (!Value.Bool && Settings.Places.count(Setting) != 0)
	{
		Messages.WarnAtKey(
			WarnInertValue, Value, Setting + " is given, but its override bit is off: the value has no effect");
		Field->SetOverridden(Settings.Settings, false);
	}
	else
	{
		Field->SetOverridden(Settings.Settings, Value.Bool);
	}
}

const std::string BlendablesName = "WeightedBlendables";

/** {"Object": "/Game/M.M", "Weight": 1} */
bool ReadBlendable(const FJsonValue& Value, FWeightedBlendable& OutBlendable)
{
	for (const auto& [Name, Member] : Value.Members)
	{
		if (Name == "Object" && (Member.Type == EJsonType::String || Member.Type == EJsonType::Null))
		{
			OutBlendable.Object = FindOrAddObject(StripObjectClass(Member.String));
		}
		else if (Name == "Weight" && Member.Type == EJsonType::Number &&
				 std::isfinite(static_cast<float>(Member.Number)))
		{
			OutBlendable.Weight = static_cast<float>(Member.Number);
		}
		else
		{
			return false;
		}
	}
	return Value.Type == EJsonType::Object;
}

void ReadBlendables(const FJsonValue& Value, FConfigSettings& Settings, FConfigMessages& Messages)
{
	const auto Refuse = [&](const FJsonValue& At)
	{
		Messages.Error(ErrorWrongType, At,
			BlendablesName +
				" must be an array of objects and weights: [{\"Object\": \"/Game/Folder/Name.Name\", \"Weight\": 1}]");
	};
	if (Value.Type != EJsonType::Array)
	{
		Refuse(Value);
		return;
	}
	for (const FJsonValue& Element : Value.Elements)
	{
		FWeightedBlendable Blendable;
		if (!ContainsInvalid(Element) && !ReadBlendable(Element, Blendable))
		{
			Refuse(Element);
		}
		Settings.Settings.WeightedBlendables.Array.Add(Blendable);
	}
	Messages.WarnAtKey(WarnNotBuilt, Value, BlendablesName + " is not built yet: no material runs");
}

} // namespace

std::string FConfigMessages::SuggestSetting(const std::string& Name) const
{
	return Name == "ScreenPercentage"
			   ? "; engine 5 has no setting of this name: set scene.screenPercentage of the config"
			   : SuggestFrom(Name, GetSettingNames);
}

FConfigSettings ReadConfigSettings(const FJsonValue& Value, FConfigMessages& Messages)
{
	FConfigSettings Settings;
	StartWithDefaults(Settings.Settings);
	for (const auto& [Name, Member] : Value.Members)
	{
		if (Name == BlendablesName)
		{
			ReadBlendables(Member, Settings, Messages);
		}
		else if (!Name.starts_with(OverridePrefix))
		{
			ReadSetting(Name, Member, Settings, Messages);
		}
	}
	for (const auto& [Name, Member] : Value.Members)
	{
		if (Name.starts_with(OverridePrefix))
		{
			ReadOverride(Name, Member, Settings, Messages);
		}
	}
	return Settings;
}

std::vector<FUnknownSetting> ReadConfigUnknownSettings(const FJsonValue& Value)
{
	std::vector<FUnknownSetting> Settings;
	for (const FJsonValue& Element : Value.Elements)
	{
		FUnknownSetting Setting;
		for (const auto& [Name, Member] : Element.Members)
		{
			std::string& Part = Name == "name" ? Setting.Key : Name == "text" ? Setting.Text : Setting.After;
			Part = Member.String;
		}
		Settings.push_back(std::move(Setting));
	}
	return Settings;
}

} // namespace Drydock
