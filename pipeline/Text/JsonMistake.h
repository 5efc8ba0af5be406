// Says in words what is wrong with a text that is not JSON, by the token before the place and the one at it.
#pragma once

#include <cstddef>
#include <string>

namespace Drydock
{

struct FJsonMistake
{
	size_t Offset = 0;   // of what is to be changed
	std::string Message; // empty: no mistake that is known by name
};

/** Text: as a parser read it. Stopped: offset of the last byte that the parser took. */
FJsonMistake DescribeJsonMistake(const std::string& Text, size_t Stopped);

} // namespace Drydock
