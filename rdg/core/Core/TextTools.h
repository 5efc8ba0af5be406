// Small functions for text that several rooms share. Letters and digits are those of ASCII.
#pragma once

#include <charconv>
#include <string>

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

/** The text with small letters for capitals. */
inline std::string ToLowerCase(std::string Text)
{
	for (char& Character : Text)
	{
		Character = Character >= 'A' && Character <= 'Z' ? static_cast<char>(Character - 'A' + 'a') : Character;
	}
	return Text;
}

/** The text without the spaces, tabs and line breaks at its ends. */
inline std::string Trim(const std::string& Text)
{
	constexpr const char* Blanks = " \t\r\n";
	const size_t First = Text.find_first_not_of(Blanks);
	return First == std::string::npos ? std::string() : Text.substr(First, Text.find_last_not_of(Blanks) - First + 1);
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

/** The shortest text that reads as the number again, in the precision of its type. */
template<typename T>
std::string FormatShortest(T Number)
{
	char Buffer[64];
	return std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Number).ptr);
}

} // namespace Drydock
