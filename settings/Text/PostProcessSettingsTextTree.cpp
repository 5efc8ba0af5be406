// Parses engine text into a tree, and writes a tree as text.
#include "PostProcessSettingsTextTree.h"

#include "PostProcessSettingsTextScan.h"
#include "TextTools.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

namespace Drydock
{

namespace
{

/** Deeper than any settings, shallow enough for recursive readers. */
constexpr int MaxDepth = 64;

/** More than any struct has; each takes some 200 bytes, however short its text. */
constexpr size_t MaxItems = 1'000'000;

/** Larger than any static array. */
constexpr size_t MaxIndexDigits = 6;

/** Signs and all: 1, -1.500000, +2, .5, 1e-3, nan, -nan(ind), inf. A number beyond double is infinite, as on reading it
 * anywhere. */
bool ReadNumberToken(const std::string& Token, double& OutNumber)
{
	const std::string Lower = ToLowerCase(Token);
	const std::string Unsigned = Lower.substr(Lower[0] == '-' || Lower[0] == '+' ? 1 : 0);
	if (Unsigned == "nan" || Unsigned.starts_with("nan("))
	{
		OutNumber = std::numeric_limits<double>::quiet_NaN();
		return true;
	}
	if (Unsigned == "inf" || Unsigned == "infinity")
	{
		OutNumber =
			Lower[0] == '-' ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
		return true;
	}
	if (Unsigned.empty() || (!IsDigit(Unsigned[0]) && Unsigned[0] != '.'))
	{
		return false;
	}
	const char* const Begin = Token.data() + (Token[0] == '+' ? 1 : 0);
	const char* const End = Token.data() + Token.size();
	const std::from_chars_result Result = std::from_chars(Begin, End, OutNumber);
	if (Result.ptr != End)
	{
		return false;
	}
	if (Result.ec == std::errc::result_out_of_range)
	{
		OutNumber = std::strtod(Begin, nullptr); // infinite, or too small for anything but 0
	}
	return Result.ec != std::errc::invalid_argument;
}

class FParser
{
public:
	FParser(const std::string& InText, size_t InAt, const std::string& InWhere, FSettingsTextMessages& InMessages)
		: Text(InText)
		, At(InAt)
		, Where(InWhere)
		, Messages(InMessages)
	{
	}

	size_t GetOffset() const { return At; }

	bool ReadValue(FEngineTextValue& OutValue)
	{
		SkipEngineTextSpace(Text, At);
		OutValue.Offset = At;
		if (Is('('))
		{
			return ReadStruct(OutValue);
		}
		if (Is('"'))
		{
			return ReadString(OutValue);
		}
		const std::string Word = ReadEngineTextWord(Text, At);
		if (Word.empty())
		{
			return Fail(At, "expected a value, found " + DescribeEngineTextAt(Text, At));
		}
		At += Word.size();
		if (Is('\''))
		{
			return ReadObject(OutValue);
		}
		if (Is('(') && !ReadCall())
		{
			return false;
		}
		OutValue.Token = Text.substr(OutValue.Offset, At - OutValue.Offset);
		SetKind(OutValue);
		return true;
	}

private:
	bool Is(char Character) const { return At < Text.size() && Text[At] == Character; }

	bool Fail(size_t Offset, const std::string& Message, ESettingsTextError Code = ErrorTextSyntax)
	{
		Messages.Error(Code, Offset, Where, Message);
		return false;
	}

	static void SetKind(FEngineTextValue& Value)
	{
		const std::string Lower = ToLowerCase(Value.Token);
		if (Lower == "true" || Lower == "false")
		{
			Value.Kind = EEngineTextKind::Bool;
			Value.Bool = Lower == "true";
		}
		else if (ReadNumberToken(Value.Token, Value.Number))
		{
			Value.Kind = EEngineTextKind::Number;
		}
		else
		{
			Value.Kind = EEngineTextKind::Name;
			Value.String = Value.Token;
		}
	}

	bool ReadStruct(FEngineTextValue& OutValue)
	{
		const size_t Open = At;
		if (++Depth > MaxDepth)
		{
			return Fail(Open, "nested deeper than " + std::to_string(MaxDepth) + " levels", ErrorTextDepth);
		}
		OutValue.Kind = EEngineTextKind::Struct;
		++At;
		SkipEngineTextSpace(Text, At);
		for (bool bMore = !Is(')'); bMore;)
		{
			FEngineTextItem Item;
			if (!ReadItem(Item, Open))
			{
				return false;
			}
			OutValue.Items.push_back(std::move(Item));
			SkipEngineTextSpace(Text, At);
			bMore = Is(',');
			At += bMore ? 1 : 0;
		}
		if (!Is(')'))
		{
			return At >= Text.size() ? Fail(Open, "this ( is never closed")
									 : Fail(At, "expected , or ) after " + NameLast(OutValue) + ", found " +
													DescribeEngineTextAt(Text, At));
		}
		++At;
		--Depth;
		return true;
	}

	static std::string NameLast(const FEngineTextValue& Struct)
	{
		const FEngineTextItem& Last = Struct.Items.back();
		return Last.Name.empty() ? Last.Value.Describe() : "the value of " + Last.GetKey();
	}

	bool ReadItem(FEngineTextItem& OutItem, size_t Open)
	{
		if (++NumItems > MaxItems)
		{
			return Fail(At, "more than " + std::to_string(MaxItems) + " values; no more are read", ErrorTextDepth);
		}
		SkipEngineTextSpace(Text, At);
		OutItem.Offset = At;
		if (At >= Text.size())
		{
			return Fail(Open, "this ( is never closed");
		}
		if (Text[At] != '(' && Text[At] != '"' && EndsEngineTextWord(Text[At]))
		{
			return Fail(At, "expected NAME=VALUE, found " + DescribeEngineTextAt(Text, At));
		}
		const std::string Word = ReadEngineTextWord(Text, At);
		size_t Behind = At + Word.size();
		SkipEngineTextSpace(Text, Behind);
		const bool bNamed = !Word.empty() && Behind < Text.size() && (Text[Behind] == '=' || Text[Behind] == '[');
		if (!bNamed)
		{
			return ReadValue(OutItem.Value);
		}
		if (!IsEngineTextName(Word))
		{
			return Fail(At, "expected a name before " + DescribeEngineTextAt(Text, Behind) + ", found " + Word);
		}
		OutItem.Name = Word;
		At = Behind;
		return ReadIndex(OutItem) && ReadItemValue(OutItem);
	}

	bool ReadIndex(FEngineTextItem& OutItem)
	{
		if (!Is('['))
		{
			return true;
		}
		const size_t Open = At++;
		SkipEngineTextSpace(Text, At);
		const std::string Word = ReadEngineTextWord(Text, At);
		const bool bDigits = !Word.empty() && Word.size() <= MaxIndexDigits && std::ranges::all_of(Word, IsDigit);
		At += Word.size();
		SkipEngineTextSpace(Text, At);
		if (!bDigits || !Is(']'))
		{
			return Fail(Open, "expected an index such as [0] after " + OutItem.Name);
		}
		++At;
		OutItem.Index = std::atoi(Word.c_str());
		SkipEngineTextSpace(Text, At);
		return Is('=') ||
			   Fail(At, "expected = after " + OutItem.GetKey() + ", found " + DescribeEngineTextAt(Text, At));
	}

	bool ReadItemValue(FEngineTextItem& OutItem)
	{
		++At; // over the =
		SkipEngineTextSpace(Text, At);
		OutItem.Value.Offset = At;
		if (Is(',') || Is(')'))
		{
			return true;
		}
		return At < Text.size() ? ReadValue(OutItem.Value)
								: Fail(OutItem.Offset, OutItem.GetKey() + " has no value: the text ends here");
	}

	/** A string stays on its line. */
	bool ReadString(FEngineTextValue& OutValue)
	{
		OutValue.Kind = EEngineTextKind::String;
		for (++At; At < Text.size() && Text[At] != '\n'; ++At)
		{
			if (Text[At] == '"')
			{
				++At;
				OutValue.Token = Text.substr(OutValue.Offset, At - OutValue.Offset);
				return true;
			}
			if (Text[At] == '\\' && At + 1 < Text.size() && Text[At + 1] != '\n')
			{
				++At;
				OutValue.String += Text[At] == 'n' ? '\n' : Text[At] == 'r' ? '\r' : Text[At] == 't' ? '\t' : Text[At];
				continue;
			}
			OutValue.String += Text[At];
		}
		return Fail(OutValue.Offset, "this \" has no closing \" on its line");
	}

	/** Class'/Game/P.P' or Class'"/Game/P.P"'. */
	bool ReadObject(FEngineTextValue& OutValue)
	{
		const size_t Open = At;
		const size_t Close = Text.find_first_of("'\n", Open + 1);
		if (Close == std::string::npos || Text[Close] == '\n')
		{
			return Fail(Open, "this ' has no closing ' on its line");
		}
		At = Close + 1;
		OutValue.Kind = EEngineTextKind::Object;
		OutValue.Token = Text.substr(OutValue.Offset, At - OutValue.Offset);
		OutValue.String = Text.substr(Open + 1, Close - Open - 1);
		if (OutValue.String.size() >= 2 && OutValue.String.front() == '"' && OutValue.String.back() == '"')
		{
			OutValue.String = OutValue.String.substr(1, OutValue.String.size() - 2);
		}
		return true;
	}

	/** The brackets of NSLOCTEXT("a", "b", "c"), nan(ind): whatever is inside, strings apart. */
	bool ReadCall()
	{
		const size_t Open = At;
		int Brackets = 0;
		bool bQuoted = false;
		for (; At < Text.size() && Text[At] != '\n'; ++At)
		{
			const char Character = Text[At];
			if (bQuoted && Character == '\\' && At + 1 < Text.size() && Text[At + 1] != '\n')
			{
				++At;
				continue;
			}
			bQuoted = bQuoted != (Character == '"');
			Brackets += bQuoted ? 0 : Character == '(' ? 1 : Character == ')' ? -1 : 0;
			if (Brackets == 0)
			{
				++At;
				return true;
			}
		}
		return Fail(Open, "this ( is not closed on its line");
	}

	const std::string& Text;
	size_t At;
	const std::string& Where;
	FSettingsTextMessages& Messages;
	int Depth = 0;
	size_t NumItems = 0;
};

} // namespace

std::string FEngineTextValue::Describe() const
{
	constexpr size_t MaxLength = 60;
	switch (Kind)
	{
	case EEngineTextKind::Nothing:
		return "nothing";
	case EEngineTextKind::Struct:
		return "a struct";
	default:
		break;
	}
	std::string Text = Token.size() <= MaxLength ? Token : Token.substr(0, MaxLength) + "...";
	std::replace_if(
		Text.begin(), Text.end(), [](char Character) { return static_cast<unsigned char>(Character) < ' '; }, '?');
	return Text;
}

std::string FEngineTextItem::GetKey() const
{
	return Index < 0 ? Name : Name + "[" + std::to_string(Index) + "]";
}

bool ParseEngineText(const std::string& Text, size_t& Offset, const std::string& Where, FEngineTextValue& OutValue,
	FSettingsTextMessages& Messages)
{
	FParser Parser(Text, Offset, Where, Messages);
	const bool bRead = Parser.ReadValue(OutValue);
	Offset = Parser.GetOffset();
	return bRead;
}

std::string ToEngineText(const FEngineTextValue& Value)
{
	if (Value.Kind != EEngineTextKind::Struct)
	{
		return Value.Token;
	}
	std::string Text = "(";
	for (const FEngineTextItem& Item : Value.Items)
	{
		Text +=
			(Text.size() > 1 ? "," : "") + (Item.Name.empty() ? "" : Item.GetKey() + "=") + ToEngineText(Item.Value);
	}
	return Text + ")";
}

} // namespace Drydock
