// Reads a time limit: a number of seconds that an environment variable can change.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

/** Seconds of the environment variable, up to a day; the default if it is not set or not a number above 0. */
inline int GetTimeLimitSeconds(const char* Variable, int Default)
{
	constexpr long Day = 24 * 60 * 60;
	const char* const Chosen = std::getenv(Variable);
	const long Seconds = Chosen ? std::strtol(Chosen, nullptr, 10) : 0;
	return Seconds > 0 ? int(std::min(Seconds, Day)) : Default;
}

} // namespace Drydock
