// Turns engine text into values by the type that is wanted. Structs are read by the reader of pasted settings.
#include "Objects/PropertyText.h"

#include "PostProcessSettingsTextTree.h"
#include "UObject/ReflectionMake.h"

#include <charconv>
#include <strings.h>

namespace Drydock
{

namespace
{

std::optional<FPropertyValue> ReadNumber(const std::string& Text)
{
	const char* const Begin = Text.data() + (Text.starts_with("+") ? 1 : 0);
	const char* End = Text.data() + Text.size();
	int64 Whole = 0;
	if (const auto Result = std::from_chars(Begin, End, Whole); Result.ptr == End && Result.ec == std::errc())
	{
		return FPropertyValue::MakeWhole(Whole);
	}
	if (End - Begin > 1 && (End[-1] == 'f' || End[-1] == 'F'))
	{
		--End; // 1.5f, which the engine reads as well
	}
	double Real = 0.0;
	const auto Result = std::from_chars(Begin, End, Real);
	return Begin != End && Result.ptr == End && Result.ec == std::errc()
			   ? std::optional(FPropertyValue::MakeNumber(Real))
			   : std::nullopt;
}

std::optional<FPropertyValue> ReadBool(const std::string& Text)
{
	for (const char* const Yes : {"True", "1", "Yes", "On"})
	{
		if (strcasecmp(Yes, Text.c_str()) == 0)
		{
			return FPropertyValue::MakeBool(true);
		}
	}
	for (const char* const No : {"False", "0", "No", "Off"})
	{
		if (strcasecmp(No, Text.c_str()) == 0)
		{
			return FPropertyValue::MakeBool(false);
		}
	}
	return std::nullopt;
}

std::optional<FPropertyValue> ReadOne(const FPropertyType& Type, const std::string& Text, bool bQuoted);

/** A part of a struct's or an array's text. */
std::optional<FPropertyValue> ReadTree(const FPropertyType& Type, const FEngineTextValue& Tree)
{
	if (Tree.Kind != EEngineTextKind::Struct)
	{
		const bool bString = Tree.Kind == EEngineTextKind::String;
		return ReadOne(Type, bString ? Tree.String : Tree.Token, bString);
	}
	const bool bNamed = !Tree.Items.empty() && !Tree.Items[0].Name.empty();
	FPropertyValue Value = bNamed ? FPropertyValue::MakeFields() : FPropertyValue::MakeList();
	const FReflectedStruct* const Struct =
		Type.Kind == EPropertyKind::Struct ? FReflection::Get().FindStruct(*Type.Type) : nullptr;
	for (const FEngineTextItem& Item : Tree.Items)
	{
		static const FPropertyType& Real = GetPropertyType<double>();
		const FPropertyType* Member = Type.Kind == EPropertyKind::Array ? Type.Element : &Real;
		if (Struct != nullptr)
		{
			const FFoundProperty Found = FReflection::Get().FindProperty(*Struct, Item.Name, true);
			Member = Found.Property != nullptr ? Found.Property->Type : &Real;
		}
		std::optional<FPropertyValue> Read = ReadTree(*Member, Item.Value);
		if (!Read || Item.Name.empty() == bNamed)
		{
			return std::nullopt;
		}
		Value.Items.emplace_back(Item.Name, std::move(*Read));
	}
	// `()` names nothing of a struct.
	Value.Kind = Value.Items.empty() && Type.Kind == EPropertyKind::Struct ? FPropertyValue::EKind::Fields : Value.Kind;
	return Value;
}

std::optional<FPropertyValue> ReadStructText(const FPropertyType& Type, const std::string& Text)
{
	std::vector<FDiagnostic> Unused; // the whole line is what is wrong
	const std::string NoFile;
	FSettingsTextMessages Messages(Text, NoFile, Unused);
	FEngineTextValue Tree;
	size_t Offset = 0;
	const bool bRead = ParseEngineText(Text, Offset, "", Tree, Messages);
	return bRead && Text.find_first_not_of(" \t", Offset) == std::string::npos && Tree.Kind == EEngineTextKind::Struct
			   ? ReadTree(Type, Tree)
			   : std::nullopt;
}

std::optional<FPropertyValue> ReadOne(const FPropertyType& Type, const std::string& Text, bool bQuoted)
{
	std::optional<FPropertyValue> Number;
	switch (Type.Kind)
	{
	case EPropertyKind::Bool:
		return ReadBool(Text);
	case EPropertyKind::Whole:
	case EPropertyKind::Real:
		return ReadNumber(Text);
	case EPropertyKind::Enum:
		Number = ReadNumber(Text);
		return Number ? Number : FPropertyValue::MakeText(Text);
	case EPropertyKind::Text:
		return FPropertyValue::MakeText(Text);
	case EPropertyKind::Vector:
	case EPropertyKind::Array:
	case EPropertyKind::Struct:
		return bQuoted ? std::nullopt : ReadStructText(Type, Text);
	case EPropertyKind::Object:
	case EPropertyKind::Other:
		break;
	}
	return FPropertyValue::MakeText(Text);
}

} // namespace

std::optional<FPropertyValue> ReadPropertyText(const FPropertyType& Type, const std::vector<FIniValue>& Values)
{
	if (Type.Kind != EPropertyKind::Array)
	{
		// !Key= leaves nothing.
		return Values.empty() ? std::nullopt : ReadOne(Type, Values.back().Text, Values.back().bQuoted);
	}
	const bool bOfStructs = Type.Element->Kind == EPropertyKind::Struct || Type.Element->Kind == EPropertyKind::Vector;
	if (Values.size() == 1 && !Values[0].bQuoted && Values[0].Text.starts_with(bOfStructs ? "((" : "("))
	{
		return ReadStructText(Type, Values[0].Text);
	}
	FPropertyValue List = FPropertyValue::MakeList();
	for (const FIniValue& Value : Values)
	{
		std::optional<FPropertyValue> Element = ReadOne(*Type.Element, Value.Text, Value.bQuoted);
		if (!Element)
		{
			return std::nullopt;
		}
		List.Items.emplace_back("", std::move(*Element));
	}
	return List;
}

} // namespace Drydock
