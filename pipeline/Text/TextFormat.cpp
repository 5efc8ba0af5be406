// Writes numbers and lists as text, and text as parts of file names.
#include "Text/TextFormat.h"

#include "Text/Fmt.inl"
#include "TextTools.h"

#include <algorithm>
#include <cctype>

namespace Drydock
{

std::string NumberText(float Number)
{
	return FormatShortest(Number);
}

std::string NumberText(double Number)
{
	return FormatShortest(Number);
}

std::string MakeFileNamePart(const std::string& Text)
{
	std::string Part = Text;
	std::replace_if(
		Part.begin(), Part.end(),
		[](char Character)
		{ return !std::isalnum(static_cast<unsigned char>(Character)) && Character != '_' && Character != '-'; },
		'_');
	return Part;
}

std::string EncodeBase64(const std::string& Bytes)
{
	constexpr char Digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	std::string Text;
	Text.reserve((Bytes.size() + 2) / 3 * 4);
	for (size_t At = 0; At < Bytes.size(); At += 3)
	{
		const size_t NumBytes = std::min<size_t>(3, Bytes.size() - At);
		uint32_t Group = 0;
		for (size_t Byte = 0; Byte < 3; ++Byte)
		{
			Group = Group << 8 | (Byte < NumBytes ? static_cast<uint8_t>(Bytes[At + Byte]) : 0u);
		}
		for (size_t Digit = 0; Digit < 4; ++Digit)
		{
			Text += Digit <= NumBytes ? Digits[Group >> (18 - 6 * Digit) & 63] : '=';
		}
	}
	return Text;
}

std::string FormatCode(int Code)
{
	return fmt::format("DD{:04}", Code);
}

std::string CsvText(const std::string& Text)
{
	if (Text.find_first_of(",\"\n") == std::string::npos)
	{
		return Text;
	}
	std::string Quoted = "\"";
	for (const char Character : Text)
	{
		Quoted += Character == '"' ? "\"\"" : std::string(1, Character);
	}
	return Quoted + "\"";
}

} // namespace Drydock
