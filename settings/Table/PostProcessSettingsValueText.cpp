// Text of single setting values, both ways. The `(R=..)` form is the engine's.
#include "PostProcessSettingsReflection.h"

#include "Math/ToInteger.h"
#include "SettingObjects.h"
#include "TextTools.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <strings.h>

namespace Drydock
{

namespace
{

bool IsFloatType(ESettingType Type)
{
	return Type == ESettingType::Float || Type == ESettingType::Color || Type == ESettingType::ColorArray;
}

/** The shortest text of a number, in the precision the field stores it. */
std::string NumberToText(double Number, bool bFloat)
{
	return bFloat ? FormatShortest(static_cast<float>(Number)) : FormatShortest(Number);
}

std::string VectorToText(const double* Components, int32 Num, bool bFloat)
{
	std::string Text;
	for (int32 Index = 0; Index < Num; ++Index)
	{
		Text += std::string(Index == 0 ? "[" : ", ") + NumberToText(Components[Index], bFloat);
	}
	return Text + "]";
}

/** As a JSON string. */
std::string QuoteForJson(const std::string& Text)
{
	std::string Quoted = "\"";
	for (const char Character : Text)
	{
		if (Character == '"' || Character == '\\')
		{
			Quoted += '\\';
		}
		Quoted += Character;
	}
	return Quoted + "\"";
}

bool NumberFromText(const std::string& Untrimmed, double& OutNumber)
{
	const std::string Text = Trim(Untrimmed);
	const char* Begin = Text.c_str() + (Text.size() > 1 && Text[0] == '+' ? 1 : 0);
	const std::from_chars_result Result = std::from_chars(Begin, Text.c_str() + Text.size(), OutNumber);
	return Result.ec == std::errc() && Result.ptr == Text.c_str() + Text.size() && std::isfinite(OutNumber);
}

bool FitsType(ESettingType Type, double Number)
{
	return IsFloatType(Type) ? std::fabs(Number) <= std::numeric_limits<float>::max()
		   : Type == ESettingType::Int
			   ? Number == std::floor(Number) && std::fabs(Number) <= std::numeric_limits<int32>::max()
			   : true;
}

/** "[1, 2]" and "(R=1,G=2)" to {"1", "2"}; components of the second form in the order given. Brackets inside stay. */
std::vector<std::string> SplitComponents(const std::string& Text)
{
	std::vector<std::string> Parts(1);
	const bool bBracketed = Text.size() >= 2 && ((Text.front() == '[' && Text.back() == ']') ||
													(Text.front() == '(' && Text.back() == ')'));
	int Depth = 0;
	for (const char Character : bBracketed ? Text.substr(1, Text.size() - 2) : Text)
	{
		Depth += (Character == '[' || Character == '(') - (Character == ']' || Character == ')');
		if (Character == ',' && Depth == 0)
		{
			Parts.emplace_back();
		}
		else
		{
			Parts.back() += Character;
		}
	}
	std::transform(Parts.begin(), Parts.end(), Parts.begin(), Trim);
	return Parts;
}

/** Drops "R=" from the first component, and so on; false when the names are not the type's, in order. */
bool StripComponentNames(ESettingType Type, std::vector<std::string>& Parts)
{
	const char* const Names = Type == ESettingType::Color ? "RGBA" : "XYZW";
	for (size_t Index = 0; Index < Parts.size(); ++Index)
	{
		const size_t Equals = Parts[Index].find('=');
		if (Equals == std::string::npos)
		{
			continue;
		}
		const std::string Name = Trim(Parts[Index].substr(0, Equals));
		if (Index >= 4 || Name != std::string(1, Names[Index]))
		{
			return false;
		}
		Parts[Index] = Parts[Index].substr(Equals + 1);
	}
	return true;
}

/** The components of one vector or colour into OutComponents. */
bool VectorFromText(ESettingType Type, const std::string& Text, size_t NumComponents, double* OutComponents)
{
	std::vector<std::string> Parts = SplitComponents(Text);
	const bool bAlphaOmitted = IsFloatType(Type) && Parts.size() == 3;
	if (!StripComponentNames(Type, Parts) || (Parts.size() != NumComponents && !bAlphaOmitted))
	{
		return false;
	}
	if (bAlphaOmitted)
	{
		Parts.emplace_back("1");
	}
	for (size_t Index = 0; Index < Parts.size(); ++Index)
	{
		if (!NumberFromText(Parts[Index], OutComponents[Index]) || !FitsType(Type, OutComponents[Index]))
		{
			return false;
		}
	}
	return true;
}

bool ComponentsFromText(
	const FSettingField& Field, const std::string& Text, FSettingValue& OutValue, std::string& OutError)
{
	const size_t Wanted = static_cast<size_t>(Field.GetNumComponents());
	const bool bRead = VectorFromText(Field.Type, Text, Wanted, OutValue.Components);
	OutError =
		bRead ? "" : "expected " + std::to_string(Wanted) + " numbers such as " + SettingToText(Field, Field.Default);
	return bRead;
}

bool ColorArrayFromText(const std::string& Text, FSettingValue& OutValue, std::string& OutError)
{
	const std::vector<std::string> Colors = SplitComponents(Text);
	bool bRead = Colors.size() == MaxSettingComponents / 4;
	for (size_t Index = 0; bRead && Index < Colors.size(); ++Index)
	{
		bRead = VectorFromText(ESettingType::Color, Colors[Index], 4, OutValue.Components + Index * 4);
	}
	OutError = bRead ? "" : "expected 8 colours such as [1, 1, 1, 1], in brackets";
	return bRead;
}

bool ObjectFromText(const FSettingField& Field, const std::string& Text, FSettingValue& OutValue, std::string& OutError)
{
	const std::string Path = StripObjectClass(Text);
	OutValue.Object = Field.FindOrAddObject(Path);
	OutError = Path.empty() ? "expected a path such as /Game/Folder/Name.Name, or None" : "";
	return !Path.empty();
}

bool EnumFromText(const FSettingField& Field, const std::string& Text, FSettingValue& OutValue, std::string& OutError)
{
	OutError = "expected one of";
	for (int32 Index = 0; Index < Field.EnumNames.Num(); ++Index)
	{
		if (Text == Field.EnumNames[Index])
		{
			OutValue.Components[0] = Index;
			OutError.clear();
			return true;
		}
		OutError += std::string(Index == 0 ? " " : ", ") + Field.EnumNames[Index];
	}
	double Number = 0.0;
	if (NumberFromText(Text, Number) && Number == std::floor(Number) && Number >= 0.0 && Number < Field.EnumNames.Num())
	{
		OutValue.Components[0] = Number;
		OutError.clear();
		return true;
	}
	return false;
}

bool BoolFromText(const std::string& Text, FSettingValue& OutValue, std::string& OutError)
{
	const bool bTrue = strcasecmp(Text.c_str(), "true") == 0 || Text == "1";
	const bool bFalse = strcasecmp(Text.c_str(), "false") == 0 || Text == "0";
	OutValue.Components[0] = bTrue ? 1.0 : 0.0;
	OutError = bTrue || bFalse ? "" : "expected true or false";
	return bTrue || bFalse;
}

} // namespace

std::string SettingToText(const FSettingField& Field, const FSettingValue& Value)
{
	switch (Field.Type)
	{
	case ESettingType::Bool:
		return Value.Components[0] != 0.0 ? "true" : "false";
	case ESettingType::Enum:
	{
		const int32 Index = ToInteger<int32>(Value.Components[0]);
		return Index >= 0 && Index < Field.EnumNames.Num() ? Field.EnumNames[Index] : std::to_string(Index);
	}
	case ESettingType::Float:
	case ESettingType::Int:
		return NumberToText(Value.Components[0], IsFloatType(Field.Type));
	case ESettingType::Object:
		return GetObjectPath(Value.Object);
	case ESettingType::ColorArray:
	{
		std::string Text;
		for (int32 Index = 0; Index < MaxSettingComponents; Index += 4)
		{
			Text += std::string(Index == 0 ? "[" : ", ") + VectorToText(Value.Components + Index, 4, true);
		}
		return Text + "]";
	}
	default:
		return VectorToText(Value.Components, Field.GetNumComponents(), IsFloatType(Field.Type));
	}
}

std::string SettingToJson(const FSettingField& Field, const FSettingValue& Value)
{
	const std::string Text = SettingToText(Field, Value);
	if (Field.Type == ESettingType::Object)
	{
		return Value.Object == nullptr ? "null" : QuoteForJson(Text);
	}
	return Field.Type == ESettingType::Enum ? QuoteForJson(Text) : Text;
}

bool SettingFromText(
	const FSettingField& Field, const std::string& UntrimmedText, FSettingValue& OutValue, std::string& OutError)
{
	const std::string Text = Trim(UntrimmedText);
	FSettingValue Value;
	Value.Type = Field.Type;
	bool bRead = false;
	switch (Field.Type)
	{
	case ESettingType::Bool:
		bRead = BoolFromText(Text, Value, OutError);
		break;
	case ESettingType::Enum:
		bRead = EnumFromText(Field, Text, Value, OutError);
		break;
	case ESettingType::Float:
	case ESettingType::Int:
		bRead = NumberFromText(Text, Value.Components[0]) && FitsType(Field.Type, Value.Components[0]);
		OutError = bRead ? "" : Field.Type == ESettingType::Int ? "expected a whole number" : "expected a number";
		break;
	case ESettingType::Object:
		bRead = ObjectFromText(Field, Text, Value, OutError);
		break;
	case ESettingType::ColorArray:
		bRead = ColorArrayFromText(Text, Value, OutError);
		break;
	default:
		bRead = ComponentsFromText(Field, Text, Value, OutError);
		break;
	}
	if (bRead)
	{
		// The field stores only what it can hold.
		FPostProcessSettings Scratch;
		Field.Set(Scratch, Value);
		OutValue = Field.Get(Scratch);
	}
	return bRead;
}

} // namespace Drydock
