// Reads lists of numbers.
#include "Program/NumberList.h"

#include "Diagnostics.h"
#include "Text/ConfigErrors.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

std::vector<double> ParseNumbers(
	const char* Option, const std::string& Text, size_t Least, size_t Most, const char* Expected)
{
	const std::vector<double> Numbers = ParseList<double>(Text);
	const bool bFinite = std::ranges::all_of(Numbers, [](double Number) { return std::isfinite(Number); });
	if (!bFinite || Numbers.size() < Least || Numbers.size() > Most)
	{
		throw BadArgument("\"" + Text + "\": expected " + Expected, Option);
	}
	return Numbers;
}

} // namespace Drydock
