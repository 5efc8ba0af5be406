// Words, spaces and places in engine text.
#include "PostProcessSettingsTextScan.h"

#include "TextTools.h"

#include <algorithm>
#include <string_view>

namespace Drydock
{

namespace
{

bool IsSpace(char Character)
{
	return Character == ' ' || Character == '\t' || Character == '\r' || Character == '\n';
}

/** Bytes of the UTF-8 character at Offset; 0 when it is none. */
size_t GetUtf8Length(const std::string& Text, size_t Offset)
{
	const auto Byte = [&](size_t Index)
	{
		return Offset + Index < Text.size() ? static_cast<unsigned char>(Text[Offset + Index]) : 0u;
	};
	const unsigned Lead = Byte(0);
	const size_t Length = Lead < 0x80 ? 1 : Lead < 0xC2 ? 0 : Lead < 0xE0 ? 2 : Lead < 0xF0 ? 3 : Lead < 0xF5 ? 4 : 0;
	for (size_t Index = 1; Index < Length; ++Index)
	{
		if ((Byte(Index) & 0xC0) != 0x80)
		{
			return 0;
		}
	}
	const bool bOverlong = (Lead == 0xE0 && Byte(1) < 0xA0) || (Lead == 0xF0 && Byte(1) < 0x90);
	const bool bNoCharacter = (Lead == 0xED && Byte(1) >= 0xA0) || (Lead == 0xF4 && Byte(1) >= 0x90);
	return bOverlong || bNoCharacter ? 0 : Length;
}

} // namespace

bool EndsEngineTextWord(char Character)
{
	return IsSpace(Character) || std::string_view("(),=[]\"'").find(Character) != std::string_view::npos;
}

void SkipEngineTextSpace(const std::string& Text, size_t& Offset)
{
	while (Offset < Text.size() && IsSpace(Text[Offset]))
	{
		++Offset;
	}
}

std::string DescribeEngineTextAt(const std::string& Text, size_t Offset)
{
	constexpr size_t MaxLength = 30;
	if (Offset >= Text.size())
	{
		return "the end of the text";
	}
	if (Text[Offset] == '\n' || Text[Offset] == '\r')
	{
		return "the end of the line";
	}
	std::string Word = ReadEngineTextWord(Text, Offset).substr(0, MaxLength);
	const auto IsPlain = [](char Character)
	{
		return Character > ' ' && Character < '\x7F';
	};
	if (!Word.empty() && std::all_of(Word.begin(), Word.end(), IsPlain))
	{
		return Word;
	}
	if (IsPlain(Text[Offset]))
	{
		return std::string("'") + Text[Offset] + "'";
	}
	constexpr char Digits[] = "0123456789abcdef";
	const auto Byte = static_cast<unsigned char>(Text[Offset]);
	return std::string("byte 0x") + Digits[Byte >> 4] + Digits[Byte & 15];
}

std::string ReadEngineTextWord(const std::string& Text, size_t Offset)
{
	size_t End = Offset;
	while (End < Text.size() && !EndsEngineTextWord(Text[End]))
	{
		++End;
	}
	return Text.substr(Offset, End - Offset);
}

bool IsEngineTextName(const std::string& Word)
{
	const auto IsNameCharacter = [](char Character)
	{
		return IsWordCharacter(Character) || static_cast<unsigned char>(Character) >= 0x80;
	};
	return !Word.empty() && !IsDigit(Word[0]) && std::all_of(Word.begin(), Word.end(), IsNameCharacter);
}

bool CheckEngineTextEncoding(const std::string& Text, FSettingsTextMessages& Messages)
{
	for (size_t At = 0; At < Text.size();)
	{
		const size_t Length = GetUtf8Length(Text, At);
		if (Length == 0 || Text[At] == '\0')
		{
			Messages.Error(ErrorTextNotUtf8, At, "",
				Length == 0 ? "the text is not UTF-8: save it as UTF-8"
							: "the text holds the character NUL: it is not UTF-8 (save it as UTF-8), or it is damaged");
			return false;
		}
		At += Length;
	}
	return true;
}

} // namespace Drydock
