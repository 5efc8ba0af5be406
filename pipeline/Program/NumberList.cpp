// Reads lists of numbers.
#include "Program/NumberList.h"

#include "Diagnostics.h"
#include "Text/ConfigErrors.h"

#include <charconv>
#include <cmath>

namespace Drydock
{

std::vector<double> ParseNumbers(
	const char* Option, const std::string& Text, size_t Least, size_t Most, const char* Expected)
{
	std::vector<double> Numbers;
	const char* Position = Text.data();
	const char* const End = Text.data() + Text.size();
	for (bool bMore = true; bMore;)
	{
		double Number = 0.0;
		const std::from_chars_result Result = std::from_chars(Position, End, Number);
		bMore = Result.ec == std::errc() && Result.ptr != End && *Result.ptr == ',';
		if (Result.ec != std::errc() || !std::isfinite(Number) || (Result.ptr != End && !bMore))
		{
			Numbers.clear();
			break;
		}
		Numbers.push_back(Number);
		Position = Result.ptr + 1;
	}
	if (Numbers.size() < Least || Numbers.size() > Most)
	{
		throw BadArgument("\"" + Text + "\": expected " + Expected, Option);
	}
	return Numbers;
}

} // namespace Drydock
