// Reads UTF-8 character by character, and writes the ones that a terminal acts on as numbers.
#include "PrintText.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace Drydock
{

namespace
{

/** Bytes of the character of UTF-8 at the beginning, and its number; 0 where none stands there. */
size_t ReadCharacter(std::string_view Text, uint32_t& OutCode)
{
	const auto ByteAt = [&Text](size_t Index)
	{
		return static_cast<unsigned char>(Text[Index]);
	};
	const unsigned char First = ByteAt(0);
	const size_t Length = First < 0x80   ? 1
						  : First < 0xC2 ? 0
						  : First < 0xE0 ? 2
						  : First < 0xF0 ? 3
						  : First < 0xF5 ? 4
										 : 0;
	if (Length == 0 || Length > Text.size())
	{
		return 0;
	}
	OutCode = Length == 1 ? First : First & (0x7F >> Length);
	for (size_t Index = 1; Index < Length; ++Index)
	{
		if ((ByteAt(Index) & 0xC0) != 0x80)
		{
			return 0;
		}
		OutCode = OutCode << 6 | (ByteAt(Index) & 0x3F);
	}
	constexpr std::array<uint32_t, 5> Least = {0, 0, 0x80, 0x800, 0x10000};
	return OutCode < Least[Length] || OutCode > 0x10FFFF || (OutCode >= 0xD800 && OutCode < 0xE000) ? 0 : Length;
}

bool IsControl(uint32_t Code, bool bLines)
{
	return (Code < 0x20 && !(bLines && (Code == '\t' || Code == '\n'))) || (Code >= 0x7F && Code < 0xA0) ||
		   (Code >= 0x202A && Code <= 0x202E) || (Code >= 0x2066 && Code <= 0x2069);
}

/** Bytes of a style that tables have; 0 where none stands there. */
size_t GetStyleLength(std::string_view Text)
{
	for (const std::string_view Style : {"\x1b[0m", "\x1b[1m", "\x1b[2m"})
	{
		if (Text.starts_with(Style))
		{
			return Style.size();
		}
	}
	return 0;
}

std::string Clean(std::string_view Text, bool bStyles, bool bLines)
{
	std::string Cleaned;
	Cleaned.reserve(Text.size());
	while (!Text.empty())
	{
		uint32_t Code = 0;
		const size_t Style = bStyles ? GetStyleLength(Text) : 0;
		const size_t Length = Style != 0 ? Style : ReadCharacter(Text, Code);
		char Number[16] = "\xEF\xBF\xBD"; // U+FFFD
		if (Length == 0 || (Style == 0 && IsControl(Code, bLines)))
		{
			if (Length != 0)
			{
				std::snprintf(Number, sizeof(Number), "\\u%04x", static_cast<unsigned>(Code));
			}
			Cleaned += Number;
		}
		else
		{
			Cleaned += Text.substr(0, Length);
		}
		Text.remove_prefix(std::max<size_t>(Length, 1));
	}
	return Cleaned;
}

} // namespace

std::string MakePrintable(const std::string& Text, bool bLines)
{
	return Clean(Text, false, bLines);
}

void PrintText(FILE* Stream, const std::string& Text)
{
	const std::string Cleaned = Clean(Text, true, true);
	std::fwrite(Cleaned.data(), 1, Cleaned.size(), Stream);
}

} // namespace Drydock
