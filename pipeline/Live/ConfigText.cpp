// Walks JSON text from member to member by the positions of its characters.
#include "Live/ConfigText.h"

#include "Live/LiveErrors.h"
#include "Text/JsonScan.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

[[noreturn]] void Refuse(const std::string& Message, const std::string& Pointer)
{
	throw FError({.Code = ErrorBadEdit, .Message = Message, .Where = Pointer}, ExitUsage);
}

size_t SkipBlanks(const std::string& Text, size_t At)
{
	while (true)
	{
		At = std::min(Text.find_first_not_of(" \t\r\n", At), Text.size());
		const size_t Behind = At < Text.size() ? SkipComment(Text, At) : At;
		if (Behind == At)
		{
			return At;
		}
		At = Behind;
	}
}

/** Offset behind the value that begins at Begin. */
size_t SkipValue(const std::string& Text, size_t Begin)
{
	int Depth = 0;
	size_t At = Begin;
	do
	{
		At = SkipBlanks(Text, At);
		const char Character = At < Text.size() ? Text[At] : '\0';
		if (Character == '\0')
		{
			return At;
		}
		Depth += Character == '{' || Character == '[' ? 1 : Character == '}' || Character == ']' ? -1 : 0;
		if (Character == '"')
		{
			At = SkipString(Text, At);
		}
		else if (IsBareCharacter(Character))
		{
			while (At < Text.size() && IsBareCharacter(Text[At]))
			{
				++At;
			}
		}
		else
		{
			++At;
		}
	} while (Depth > 0);
	return At;
}

/** A member or an element, by the positions of its parts. */
struct FItem
{
	std::string Key = {}; // of a member, in quotes
	size_t Begin = 0;     // of the key, or of the element
	size_t Value = 0;
	size_t End = 0;
	size_t Comma = std::string::npos; // behind it
};

/** The items of an object or array, which begins at Begin. */
std::vector<FItem> ListItems(const std::string& Text, size_t Begin)
{
	std::vector<FItem> Items;
	const bool bObject = Text[Begin] == '{';
	for (size_t At = SkipBlanks(Text, Begin + 1); At < Text.size() && Text[At] != '}' && Text[At] != ']';)
	{
		FItem Item{.Begin = At, .Value = At};
		if (bObject)
		{
			const size_t KeyEnd = SkipString(Text, At);
			Item.Key = Text.substr(At, KeyEnd - At);
			Item.Value = SkipBlanks(Text, SkipBlanks(Text, KeyEnd) + 1);
		}
		Item.End = SkipValue(Text, Item.Value);
		At = SkipBlanks(Text, Item.End);
		if (At < Text.size() && Text[At] == ',')
		{
			Item.Comma = At;
			At = SkipBlanks(Text, At + 1);
		}
		Items.push_back(Item);
	}
	return Items;
}

/** Index of the step's item; the number of items where it is missing and may be added; -1 where it cannot be. */
int FindItemIndex(const std::string& Text, size_t Begin, const std::vector<FItem>& Items, const std::string& Step)
{
	const int Count = static_cast<int>(Items.size());
	if (Text[Begin] == '{')
	{
		const std::string Key = FJsonWriter::Quote(Step);
		const auto Found = std::ranges::find(Items, Key, &FItem::Key);
		return static_cast<int>(Found - Items.begin());
	}
	if (Text[Begin] != '[')
	{
		return -1;
	}
	const bool bNumber = !Step.empty() && Step.size() < 9 && std::ranges::all_of(Step, IsDigit);
	const int Index = Step == "-" ? Count : bNumber ? std::stoi(Step) : -1;
	return Index <= Count ? Index : -1;
}

/** The end of the line at At if nothing but blanks and a comment is left on it, else At. */
size_t FindQuietLineEnd(const std::string& Text, size_t At)
{
	const size_t Next = std::min(Text.find_first_not_of(" \t\r", At), Text.size());
	const bool bComment = Text.compare(Next, 2, "//") == 0;
	if (!bComment && Next < Text.size() && Text[Next] != '\n')
	{
		return At;
	}
	return std::min(Text.find('\n', Next), Text.size());
}

/** The blanks before At on its line; nothing where something else is there. */
std::optional<std::string> FindIndent(const std::string& Text, size_t At)
{
	const size_t LineBegin = At == 0 ? 0 : Text.rfind('\n', At - 1) + 1; // npos + 1 is 0
	const std::string Indent = Text.substr(LineBegin, At - LineBegin);
	return Indent.find_first_not_of(" \t") == std::string::npos ? std::optional(Indent) : std::nullopt;
}

void InsertItem(std::string& Text, size_t Begin, const std::vector<FItem>& Items, const std::string& Item)
{
	if (Items.empty())
	{
		Text.insert(Begin + 1, Item);
		return;
	}
	const FItem& Last = Items.back();
	const std::optional<std::string> Indent = FindIndent(Text, Last.Begin);
	const size_t LineEnd = FindQuietLineEnd(Text, Last.End);
	if (!Indent || LineEnd == Last.End)
	{
		Text.insert(Last.End, (Indent ? ",\n" + *Indent : ", ") + Item);
		return;
	}
	Text.insert(LineEnd, "\n" + *Indent + Item);
	Text.insert(Last.End, ",");
}

void RemoveItem(std::string& Text, const std::vector<FItem>& Items, size_t Index)
{
	const FItem& Item = Items[Index];
	const bool bLast = Index + 1 == Items.size();
	size_t End = Item.Comma != std::string::npos ? Item.Comma + 1 : Item.End;
	size_t Begin = Item.Begin;
	const size_t LineEnd = FindQuietLineEnd(Text, End);
	if (const std::optional<std::string> Indent = FindIndent(Text, Begin);
		Indent && (LineEnd != End || LineEnd == Text.size() || Text[LineEnd] == '\n') && Begin > Indent->size())
	{
		Begin -= Indent->size() + 1; // the whole line, with the comment that belongs to it
		End = LineEnd;
	}
	else if (!bLast)
	{
		End = SkipBlanks(Text, End);
	}
	Text.erase(Begin, End - Begin);
	if (bLast && Index > 0)
	{
		const size_t Comma = Items[Index - 1].Comma;
		Text.erase(Comma, 1 + (Begin == Comma + 2 && Text[Comma + 1] == ' ' ? 1 : 0));
	}
}

/** The value inside new objects, one for each step. */
std::string Wrap(const std::vector<std::string>& Steps, size_t First, const std::string& Value)
{
	std::string Text = Value;
	for (size_t Step = Steps.size(); Step-- > First;)
	{
		Text = "{" + FJsonWriter::Quote(Steps[Step]) + ": " + Text + "}";
	}
	return Text;
}

void ApplyEdit(std::string& Text, const FConfigEdit& Edit)
{
	const std::vector<std::string> Steps = SplitPointer(Edit.Pointer);
	size_t At = SkipBlanks(Text, 0);
	if (Steps.empty() || At == Text.size())
	{
		Refuse("an edit needs a place in the config", Edit.Pointer);
	}
	for (size_t Step = 0; Step < Steps.size(); ++Step)
	{
		const std::vector<FItem> Items =
			Text[At] == '{' || Text[At] == '[' ? ListItems(Text, At) : std::vector<FItem>();
		const int Found = FindItemIndex(Text, At, Items, Steps[Step]);
		if (Found < 0)
		{
			Refuse("there is no place " + Steps[Step] + " in what stands there", Edit.Pointer);
		}
		const size_t Index = static_cast<size_t>(Found);
		const bool bLast = Step + 1 == Steps.size();
		if (Index == Items.size())
		{
			if (!Edit.Value)
			{
				Refuse("there is nothing to remove", Edit.Pointer);
			}
			const std::string Key = Text[At] == '{' ? FJsonWriter::Quote(Steps[Step]) + ": " : "";
			InsertItem(Text, At, Items, Key + Wrap(Steps, Step + 1, *Edit.Value));
			return;
		}
		const FItem& Item = Items[Index];
		if (bLast)
		{
			if (Edit.Value)
			{
				Text.replace(Item.Value, Item.End - Item.Value, *Edit.Value);
			}
			else
			{
				RemoveItem(Text, Items, Index);
			}
			return;
		}
		At = Item.Value;
	}
}

void WriteInto(FJsonWriter& Writer, const FJsonValue& Value)
{
	switch (Value.Type)
	{
	case EJsonType::Bool:
		return Writer.Value(Value.Bool);
	case EJsonType::Number:
		return Writer.Value(Value.Number);
	case EJsonType::String:
		return Writer.Value(Value.String);
	case EJsonType::Array:
		Writer.BeginArray(true);
		for (const FJsonValue& Element : Value.Elements)
		{
			WriteInto(Writer, Element);
		}
		return Writer.EndArray();
	case EJsonType::Object:
		Writer.BeginObject(true);
		for (const FJsonMember& Member : Value.Members)
		{
			WriteInto(Writer.Key(Member.Key), Member.Value);
		}
		return Writer.EndObject();
	case EJsonType::Null:
	case EJsonType::Invalid:
		break;
	}
	Writer.Null();
}

void AddChanges(const FJsonValue& Before, const FJsonValue& After, std::vector<FConfigEdit>& Changes)
{
	FJsonValue Nothing;
	Nothing.Type = EJsonType::Object;
	if (Before.Type == EJsonType::Array && After.Type == EJsonType::Array &&
		Before.Elements.size() == After.Elements.size())
	{
		for (size_t Index = 0; Index < After.Elements.size(); ++Index)
		{
			AddChanges(Before.Elements[Index], After.Elements[Index], Changes);
		}
		return;
	}
	if (Before.Type != EJsonType::Object || After.Type != EJsonType::Object)
	{
		if (WriteJson(Before) != WriteJson(After))
		{
			Changes.push_back({After.Pointer, WriteJson(After)});
		}
		return;
	}
	for (const FJsonMember& Member : After.Members)
	{
		const FJsonValue* const Known = Before.Find(Member.Key);
		const bool bMade = Known == nullptr && !Member.Value.Members.empty(); // on the way to its own members
		if (Known != nullptr || bMade)
		{
			AddChanges(bMade ? Nothing : *Known, Member.Value, Changes);
		}
		else
		{
			Changes.push_back({Member.Value.Pointer, WriteJson(Member.Value)});
		}
	}
	for (const FJsonMember& Member : Before.Members)
	{
		if (After.Find(Member.Key) == nullptr)
		{
			Changes.push_back({Member.Value.Pointer, std::nullopt});
		}
	}
}

FJsonValue Parse(const std::string& Text)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	return ParseJson(Text, "", Ignored, bSyntaxError);
}

} // namespace

std::vector<FConfigEdit> FindChanges(const std::string& Before, const std::string& After)
{
	std::vector<FConfigEdit> Changes;
	AddChanges(Parse(Before), Parse(After), Changes);
	return Changes;
}

std::vector<std::string> SplitPointer(const std::string& Pointer)
{
	if (Pointer.empty())
	{
		return {};
	}
	if (Pointer[0] != '/')
	{
		Refuse("a place is a JSON pointer, such as /camera/Settings/BloomIntensity", Pointer);
	}
	std::vector<std::string> Steps = SplitText(Pointer.substr(1) + "/", '/');
	for (std::string& Step : Steps)
	{
		for (size_t At = 0; (At = Step.find('~', At)) != std::string::npos; ++At)
		{
			const char Escaped = At + 1 < Step.size() ? Step[At + 1] : '\0';
			if (Escaped != '0' && Escaped != '1')
			{
				Refuse("~ stands in a JSON pointer as ~0, and / as ~1", Pointer);
			}
			Step.replace(At, 2, Escaped == '0' ? "~" : "/");
		}
	}
	return Steps;
}

std::string WriteJson(const FJsonValue& Value)
{
	FJsonWriter Writer;
	WriteInto(Writer, Value);
	return Trim(Writer.GetText());
}

std::vector<FConfigEdit> ReadEdits(const FJsonValue& Edits)
{
	std::vector<FConfigEdit> Read;
	if (Edits.Type != EJsonType::Array || Edits.Elements.empty())
	{
		Refuse("expected \"edits\": a list of {\"set\": PLACE, \"value\": ...} and {\"remove\": PLACE}", "/edits");
	}
	for (const FJsonValue& Edit : Edits.Elements)
	{
		const FJsonValue* const Set = Edit.Find("set");
		const FJsonValue* const Value = Edit.Find("value");
		const FJsonValue* const Place = Set != nullptr ? Set : Edit.Find("remove");
		if (Place == nullptr || Place->Type != EJsonType::String || (Set != nullptr) != (Value != nullptr))
		{
			Refuse("an edit is {\"set\": PLACE, \"value\": ...} or {\"remove\": PLACE}", Edit.Pointer);
		}
		SplitPointer(Place->String); // its mistakes
		Read.push_back({Place->String, Value != nullptr ? std::optional(WriteJson(*Value)) : std::nullopt});
	}
	return Read;
}

std::string WriteEdit(const FConfigEdit& Edit)
{
	FJsonWriter Writer;
	Writer.BeginObject(true);
	Writer.Member(Edit.Value ? "set" : "remove", Edit.Pointer);
	Writer.RawMember("value", Edit.Value.value_or(""));
	Writer.EndObject();
	return Trim(Writer.GetText());
}

std::string ApplyEdits(const std::string& Text, const std::vector<FConfigEdit>& Edits)
{
	std::string Edited = Text;
	for (const FConfigEdit& Edit : Edits)
	{
		ApplyEdit(Edited, Edit);
	}
	return Edited;
}

std::optional<std::string> FindPlace(const std::string& Text, const std::string& Pointer)
{
	size_t At = SkipBlanks(Text, 0);
	for (const std::string& Step : SplitPointer(Pointer))
	{
		if (At >= Text.size() || (Text[At] != '{' && Text[At] != '['))
		{
			return std::nullopt;
		}
		const std::vector<FItem> Items = ListItems(Text, At);
		const int Index = FindItemIndex(Text, At, Items, Step);
		if (Index < 0 || static_cast<size_t>(Index) == Items.size())
		{
			return std::nullopt;
		}
		At = Items[static_cast<size_t>(Index)].Value;
	}
	return Text.substr(At, SkipValue(Text, At) - At);
}

} // namespace Drydock
