// Splits logs into lines, for readers that search them by regular expressions.
#pragma once

#include <charconv>
#include <string>

namespace Drydock
{

/** Cuts a line to the length that is searched: std::regex calls itself for every character, and a line of some 20,000
 * fills the stack. Compilers write such lines about templates. */
inline std::string CutLine(const std::string& Line)
{
	size_t End = 2000;
	if (Line.size() <= End)
	{
		return Line;
	}
	while (End > 0 && (static_cast<unsigned char>(Line[End]) & 0xC0) == 0x80)
	{
		--End; // no character of UTF-8 is cut in two
	}
	return Line.substr(0, End);
}

/** 0 where the digits are not the number of a line. */
inline int ReadLineNumber(const std::string& Digits)
{
	int Number = 0;
	const std::from_chars_result Result = std::from_chars(Digits.data(), Digits.data() + Digits.size(), Number);
	return Result.ec == std::errc() ? Number : 0;
}

} // namespace Drydock
