// Lists of numbers as options take them: "1,2,3".
#pragma once

#include <string>
#include <vector>

namespace Drydock
{

/** The numbers of Text, as many as Least to Most. Throws FError (exit code 2), which names the option and what was
 * expected, where it is anything else. */
std::vector<double> ParseNumbers(
	const char* Option, const std::string& Text, size_t Least, size_t Most, const char* Expected);

} // namespace Drydock
