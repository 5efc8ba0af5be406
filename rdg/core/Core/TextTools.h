// Small functions for text that several rooms share. Letters and digits are those of ASCII.
#pragma once

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace Drydock
{

/** Whether it is one of 0 to 9. */
constexpr bool IsDigit(char Character)
{
	return Character >= '0' && Character <= '9';
}

/** Whether a name of C++, HLSL or the engine's text may have it: a letter, a digit or an underscore. */
constexpr bool IsWordCharacter(char Character)
{
	return (Character >= 'a' && Character <= 'z') || (Character >= 'A' && Character <= 'Z') || IsDigit(Character) ||
		   Character == '_';
}

/** A small letter for a capital. */
constexpr char ToLowerCase(char Character)
{
	return Character >= 'A' && Character <= 'Z' ? static_cast<char>(Character - 'A' + 'a') : Character;
}

/** The text with small letters for capitals. */
inline std::string ToLowerCase(std::string Text)
{
	for (char& Character : Text)
	{
		Character = ToLowerCase(Character);
	}
	return Text;
}

/** The text without the spaces, tabs and breaks of lines and pages at its ends. */
inline std::string Trim(std::string_view Text)
{
	constexpr const char* Blanks = " \t\r\n\v\f";
	const size_t First = Text.find_first_not_of(Blanks);
	return std::string(
		First == Text.npos ? std::string_view() : Text.substr(First, Text.find_last_not_of(Blanks) - First + 1));
}

/** The parts of a text between separators, its lines by default. A separator at the end is followed by no part. */
inline std::vector<std::string> SplitText(std::string_view Text, char Separator = '\n')
{
	std::vector<std::string> Parts;
	for (size_t Begin = 0; Begin < Text.size();)
	{
		const size_t End = std::min(Text.find(Separator, Begin), Text.size());
		Parts.emplace_back(Text.substr(Begin, End - Begin));
		Begin = End + 1;
	}
	return Parts;
}

/** The rows of a table, a line each, with tabs between the columns. Empty lines and comments, which begin with #, are
 * left out. */
inline std::vector<std::vector<std::string>> SplitRows(std::string_view Text)
{
	std::vector<std::vector<std::string>> Rows;
	for (const std::string& Line : SplitText(Text))
	{
		if (!Line.empty() && Line[0] != '#')
		{
			Rows.push_back(SplitText(Line, '\t'));
		}
	}
	return Rows;
}

/** The strings of a range, or those that a function gives for its items, with the separator between them. */
template<typename TRange, typename TFunction = std::identity>
std::string JoinText(const TRange& Parts, std::string_view Separator = ", ", TFunction Function = {})
{
	std::string Text;
	for (const auto& Part : Parts)
	{
		Text.append(Text.empty() ? std::string_view() : Separator).append(std::invoke(Function, Part));
	}
	return Text;
}

/** "A, B and C", or with another word before the last. */
inline std::string JoinWords(const std::vector<std::string>& Words, const std::string& Word = " and ")
{
	std::string Text;
	for (size_t Index = 0; Index < Words.size(); ++Index)
	{
		Text += (Index == 0 ? "" : Index + 1 < Words.size() ? ", " : Word) + Words[Index];
	}
	return Text;
}

/** "A, B, C and 4 more"; it names MaxNamed at most. */
inline std::string ListSome(const std::vector<std::string>& Names, size_t MaxNamed)
{
	const std::string Text = JoinText(std::span(Names).first(std::min(Names.size(), MaxNamed)));
	return Names.size() > MaxNamed ? Text + " and " + std::to_string(Names.size() - MaxNamed) + " more" : Text;
}

/** The text between quotes of C++, in one line: every name of a stranger's that stands in code is written by this
 * alone. Control characters are left out. */
inline std::string QuoteForCpp(const std::string& Text)
{
	std::string Quoted = "\"";
	for (const char Character : Text)
	{
		const unsigned char Code = static_cast<unsigned char>(Character);
		if (Character == '"' || Character == '\\' || Character == '?') // two of these might begin a trigraph
		{
			Quoted += '\\';
		}
		if (Code >= ' ' && Code != 0x7f)
		{
			Quoted += Character;
		}
	}
	return Quoted + "\"";
}

/** The escape that C++, JSON and the engine's text have for a character; empty where it needs none. */
constexpr std::string_view FindEscape(char Character)
{
	constexpr std::string_view Characters = "\"\\\n\r\t";
	constexpr std::string_view Escapes[] = {"\\\"", "\\\\", "\\n", "\\r", "\\t"};
	const size_t Index = Characters.find(Character);
	return Index == Characters.npos ? std::string_view() : Escapes[Index];
}

/** The number that the whole text is; nothing where it is none. */
template<typename T>
std::optional<T> ParseAll(std::string_view Text)
{
	T Number{};
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), Number);
	return Result.ec == std::errc() && Result.ptr == Text.data() + Text.size() ? std::optional(Number) : std::nullopt;
}

/** The numbers of a list with commas between them, and blanks around them; none where a part is not a number. */
template<typename T>
std::vector<T> ParseList(std::string_view Text)
{
	std::vector<T> Numbers;
	for (const std::string& Part : SplitText(std::string(Text) + ",", ','))
	{
		const std::optional<T> Number = ParseAll<T>(Trim(Part));
		if (!Number)
		{
			return {};
		}
		Numbers.push_back(*Number);
	}
	return Numbers;
}

/** The shortest text that reads as the number again, in the precision of its type. */
template<typename T>
std::string FormatShortest(T Number)
{
	char Buffer[64];
	return std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Number).ptr);
}

} // namespace Drydock
