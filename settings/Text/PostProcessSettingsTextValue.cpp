// Turns a node of engine text into a field's value, and a value into text.
#include "PostProcessSettingsTextValue.h"

#include "Math/ToInteger.h"
#include "SettingObjects.h"
#include "TextTools.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

constexpr const char* ColorNames[] = {"R", "G", "B", "A"};
constexpr const char* VectorNames[] = {"X", "Y", "Z", "W"};

bool IsColor(const FSettingField& Field)
{
	return Field.Type == ESettingType::Color || Field.Type == ESettingType::ColorArray;
}

bool IsFloat(const FSettingField& Field)
{
	return Field.Type == ESettingType::Float || IsColor(Field);
}

/** Components of one element. */
int GetNumParts(const FSettingField& Field)
{
	return Field.Type == ESettingType::ColorArray ? 4 : Field.GetNumComponents();
}

const char* GetPartName(const FSettingField& Field, int Index)
{
	return IsColor(Field) ? ColorNames[Index] : VectorNames[Index];
}

/** "R, G, B, A" */
std::string ListParts(const FSettingField& Field)
{
	std::string Names;
	for (int Index = 0; Index < GetNumParts(Field); ++Index)
	{
		Names += std::string(Index == 0 ? "" : ", ") + GetPartName(Field, Index);
	}
	return Names;
}

/** "(R=..,G=..,B=..,A=..)" */
std::string ExampleOfParts(const FSettingField& Field)
{
	std::string Example = "(";
	for (int Index = 0; Index < GetNumParts(Field); ++Index)
	{
		Example += std::string(Index == 0 ? "" : ",") + GetPartName(Field, Index) + "=..";
	}
	return Example + ")";
}

bool Refuse(
	FSettingTextProblem& OutProblem, ESettingsTextError Code, const FEngineTextValue& Text, const std::string& Message)
{
	OutProblem = {Code, Text.Offset, Message};
	return false;
}

bool Expected(FSettingTextProblem& OutProblem, const FEngineTextValue& Text, const std::string& What)
{
	return Refuse(OutProblem, ErrorTextWrongType, Text, "expected " + What + ", found " + Text.Describe());
}

bool ReadNumber(const FEngineTextValue& Text, bool bFloat, double& OutNumber, FSettingTextProblem& OutProblem)
{
	if (Text.Kind != EEngineTextKind::Number)
	{
		return Expected(OutProblem, Text, "a number");
	}
	if (!std::isfinite(bFloat ? static_cast<float>(Text.Number) : Text.Number))
	{
		return Refuse(OutProblem, ErrorTextNotFinite, Text, "expected a finite number, found " + Text.Describe());
	}
	OutNumber = Text.Number;
	return true;
}

bool ReadWhole(const FEngineTextValue& Text, double& OutNumber, FSettingTextProblem& OutProblem)
{
	const bool bWhole = Text.Kind == EEngineTextKind::Number && Text.Number == std::floor(Text.Number) &&
						std::fabs(Text.Number) <= std::numeric_limits<int32>::max();
	OutNumber = bWhole ? Text.Number : OutNumber;
	return bWhole || Expected(OutProblem, Text, "a whole number");
}

bool ReadBool(const FEngineTextValue& Text, double& OutNumber, FSettingTextProblem& OutProblem)
{
	const bool bDigit = Text.Kind == EEngineTextKind::Number && (Text.Number == 0.0 || Text.Number == 1.0);
	if (Text.Kind != EEngineTextKind::Bool && !bDigit)
	{
		return Expected(OutProblem, Text, "True or False");
	}
	OutNumber = bDigit ? Text.Number : Text.Bool ? 1.0 : 0.0;
	return true;
}

bool ReadEnum(
	const FSettingField& Field, const FEngineTextValue& Text, double& OutNumber, FSettingTextProblem& OutProblem)
{
	if (Text.Kind == EEngineTextKind::Number && Text.Number == std::floor(Text.Number) && Text.Number >= 0.0 &&
		Text.Number < Field.EnumNames.Num())
	{
		OutNumber = Text.Number;
		return true;
	}
	const size_t Qualifier = Text.String.rfind("::");
	const std::string Name = Text.String.substr(Qualifier == std::string::npos ? 0 : Qualifier + 2);
	const bool bText = Text.Kind == EEngineTextKind::Name || Text.Kind == EEngineTextKind::String;
	std::vector<std::string> Names;
	std::string List;
	for (int32 Index = 0; Index < Field.EnumNames.Num(); ++Index)
	{
		if (bText && ToLowerCase(Name) == ToLowerCase(Field.EnumNames[Index]))
		{
			OutNumber = Index;
			return true;
		}
		Names.emplace_back(Field.EnumNames[Index]);
		List += std::string(Index == 0 ? " " : ", ") + Names.back();
	}
	return Refuse(OutProblem, bText ? ErrorTextUnknownName : ErrorTextWrongType, Text,
		"expected one of" + List + ", found " + Text.Describe() + (bText ? SuggestName(Name, Names) : ""));
}

/** (R=..,G=..,B=..,A=..), any of them, in any order. */
bool ReadParts(
	const FSettingField& Field, const FEngineTextValue& Text, double* InOutParts, FSettingTextProblem& OutProblem)
{
	if (Text.Kind != EEngineTextKind::Struct)
	{
		return Expected(OutProblem, Text, ExampleOfParts(Field));
	}
	for (const FEngineTextItem& Item : Text.Items)
	{
		int Part = 0;
		while (Part < GetNumParts(Field) && ToLowerCase(Item.Name) != ToLowerCase(GetPartName(Field, Part)))
		{
			++Part;
		}
		if (Part == GetNumParts(Field) || Item.Index >= 0)
		{
			OutProblem = {ErrorTextUnknownName, Item.Offset,
				"expected " + ListParts(Field) + " in " + ExampleOfParts(Field) + ", found " +
					(Item.Name.empty() ? Item.Value.Describe() : Item.GetKey())};
			return false;
		}
		if (!ReadNumber(Item.Value, IsFloat(Field), InOutParts[Part], OutProblem))
		{
			return false;
		}
	}
	return true;
}

bool IsNone(const std::string& Path)
{
	return Path.empty() || ToLowerCase(Path) == "none";
}

/** With what a string needs escaped. */
std::string Quote(const std::string& Text)
{
	std::string Quoted = "\"";
	for (const char Character : Text)
	{
		const std::string_view Escape = FindEscape(Character);
		Escape.empty() ? Quoted += Character : Quoted += Escape;
	}
	return Quoted + "\"";
}

/** The path of None, Class'/Game/P.P', "Class'/Game/P.P'", "/Game/P.P" and /Game/P.P. */
bool ReadPath(const FEngineTextValue& Text, std::string& OutPath, FSettingTextProblem& OutProblem)
{
	const bool bPath = Text.Kind == EEngineTextKind::String || Text.Kind == EEngineTextKind::Object ||
					   (Text.Kind == EEngineTextKind::Name && (Text.String[0] == '/' || IsNone(Text.String)));
	if (!bPath)
	{
		return Expected(
			OutProblem, Text, "an object such as /Script/Engine.Texture2D'/Game/Folder/Name.Name', or None");
	}
	const std::string Path = StripObjectClass(Text.String);
	OutPath = IsNone(Path) ? "None" : Path;
	return true;
}

/** Textures are written by the class that nearly all have; the table knows no nearer one. */
std::string WriteObject(const FSettingField& Field, const UObject* Object)
{
	const std::string Class = Field.ObjectClass;
	return Object == nullptr ? "None"
							 : Quote("/Script/Engine." + (Class == "Texture" ? "Texture2D" : Class) + "'" +
									 GetObjectPath(Object) + "'");
}

/** Stores the value that a float or double field holds after reading the text. */
bool StoreFinite(const FSettingField& Field, const FSettingValue& Value, FSettingValue& OutValue)
{
	FPostProcessSettings Scratch;
	Field.Set(Scratch, Value);
	OutValue = Field.Get(Scratch);
	return true;
}

} // namespace

bool ReadSettingText(const FSettingField& Field, const FEngineTextValue& Text, FSettingValue& InOutValue,
	FSettingTextProblem& OutProblem)
{
	FSettingValue Value = InOutValue;
	switch (Field.Type)
	{
	case ESettingType::Float:
		return ReadNumber(Text, true, Value.Components[0], OutProblem) && StoreFinite(Field, Value, InOutValue);
	case ESettingType::Int:
		return ReadWhole(Text, Value.Components[0], OutProblem) && StoreFinite(Field, Value, InOutValue);
	case ESettingType::Bool:
		return ReadBool(Text, Value.Components[0], OutProblem) && StoreFinite(Field, Value, InOutValue);
	case ESettingType::Enum:
		return ReadEnum(Field, Text, Value.Components[0], OutProblem) && StoreFinite(Field, Value, InOutValue);
	case ESettingType::Object:
	{
		std::string Path;
		if (!ReadPath(Text, Path, OutProblem))
		{
			return false;
		}
		Value.Object = Field.FindOrAddObject(Path);
		return StoreFinite(Field, Value, InOutValue);
	}
	case ESettingType::ColorArray:
		return Refuse(OutProblem, ErrorTextIndex, Text,
			std::string("expected an index: ") + Field.Name + "[0] to " + Field.Name + "[" +
				std::to_string(GetNumTextElements(Field) - 1) + "]");
	case ESettingType::Color:
	case ESettingType::Vector2:
	case ESettingType::Vector4:
		return ReadParts(Field, Text, Value.Components, OutProblem) && StoreFinite(Field, Value, InOutValue);
	}
	return false;
}

bool ReadSettingTextElement(const FSettingField& Field, int Index, const FEngineTextValue& Text,
	FSettingValue& InOutValue, FSettingTextProblem& OutProblem)
{
	if (Field.Type != ESettingType::ColorArray)
	{
		return Refuse(OutProblem, ErrorTextIndex, Text, std::string(Field.Name) + " is not an array and has no index");
	}
	if (Index >= GetNumTextElements(Field))
	{
		return Refuse(OutProblem, ErrorTextIndex, Text,
			std::string(Field.Name) + " has indices 0 to " + std::to_string(GetNumTextElements(Field) - 1));
	}
	FSettingValue Value = InOutValue;
	return ReadParts(Field, Text, Value.Components + Index * GetNumParts(Field), OutProblem) &&
		   StoreFinite(Field, Value, InOutValue);
}

int GetNumTextElements(const FSettingField& Field)
{
	return Field.Type == ESettingType::ColorArray ? MaxSettingComponents / 4 : 1;
}

std::string WriteSettingText(const FSettingField& Field, const FSettingValue& Value, int Index)
{
	switch (Field.Type)
	{
	case ESettingType::Float:
		return WriteNumberText(Value.Components[0]);
	case ESettingType::Int:
		return std::to_string(ToInteger<int32>(Value.Components[0]));
	case ESettingType::Bool:
		return Value.Components[0] != 0.0 ? "True" : "False";
	case ESettingType::Enum:
		return SettingToText(Field, Value);
	case ESettingType::Object:
		return WriteObject(Field, Value.Object);
	default:
		break;
	}
	std::string Text = "(";
	for (int Part = 0; Part < GetNumParts(Field); ++Part)
	{
		Text += std::string(Part == 0 ? "" : ",") + GetPartName(Field, Part) + "=" +
				WriteNumberText(Value.Components[Index * GetNumParts(Field) + Part]);
	}
	return Text + ")";
}

std::string WriteNumberText(double Number)
{
	char Buffer[400]; // the largest double has 309 digits
	const std::to_chars_result Result =
		std::to_chars(Buffer, Buffer + sizeof(Buffer), Number, std::chars_format::fixed, 6);
	return std::string(Buffer, Result.ptr);
}

bool ReadBlendablesText(
	const FEngineTextValue& Text, FWeightedBlendables& OutBlendables, FSettingTextProblem& OutProblem)
{
	constexpr const char* Example = "(Array=((Weight=..,Object=..)))";
	FWeightedBlendables Blendables;
	const bool bWrapped = Text.Kind == EEngineTextKind::Struct && Text.Items.size() == 1 &&
						  ToLowerCase(Text.Items[0].Name) == "array" && Text.Items[0].Index < 0;
	const FEngineTextValue& Array = bWrapped ? Text.Items[0].Value : Text;
	if (Array.Kind != EEngineTextKind::Struct && Array.Kind != EEngineTextKind::Nothing)
	{
		return Expected(OutProblem, Array, Example);
	}
	for (const FEngineTextItem& Element : Array.Items)
	{
		FWeightedBlendable Blendable;
		if (!Element.Name.empty() || Element.Value.Kind != EEngineTextKind::Struct)
		{
			OutProblem = {ErrorTextWrongType, Element.Offset,
				std::string("expected ") + Example + ", found " +
					(Element.Name.empty() ? Element.Value.Describe() : Element.GetKey())};
			return false;
		}
		for (const FEngineTextItem& Member : Element.Value.Items)
		{
			const std::string Name = ToLowerCase(Member.Name);
			double Weight = 0.0;
			std::string Path;
			if (Name == "weight" ? !ReadNumber(Member.Value, true, Weight, OutProblem)
								 : Name == "object" && !ReadPath(Member.Value, Path, OutProblem))
			{
				return false;
			}
			if (Name == "weight")
			{
				Blendable.Weight = static_cast<float>(Weight);
			}
			else if (Name == "object")
			{
				Blendable.Object = FindOrAddObject(Path);
			}
			else
			{
				OutProblem = {ErrorTextUnknownName, Member.Offset,
					"expected Weight or Object, found " +
						(Member.Name.empty() ? Member.Value.Describe() : Member.GetKey())};
				return false;
			}
		}
		Blendables.Array.Add(Blendable);
	}
	OutBlendables = Blendables;
	return true;
}

std::string WriteBlendablesText(const FWeightedBlendables& Blendables)
{
	if (Blendables.Array.Num() == 0)
	{
		return "(Array=)";
	}
	std::string Text;
	for (const FWeightedBlendable& Blendable : Blendables.Array)
	{
		const std::string Path = GetObjectPath(Blendable.Object.Get());
		Text += std::string(Text.empty() ? "" : ",") + "(Weight=" + WriteNumberText(Blendable.Weight) +
				",Object=" + (Path == "None" ? Path : Quote(Path)) + ")";
	}
	return "(Array=(" + Text + "))";
}

} // namespace Drydock
