// How many random programs to run, and each in which form: every program runs as one kernel, by the interpreter, and by
// the interpreter with its functions.
#pragma once

#include "ShaderHarness.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace Drydock::Test
{

constexpr int GDefaultRandomPrograms = 60;

/** Of a kind that has this share of all; DRYDOCK_RANDOM_PROGRAMS says how many those are (docs/testing.md). */
inline int CountRandomPrograms(int Percent)
{
	const char* const Asked = std::getenv("DRYDOCK_RANDOM_PROGRAMS");
	const int All = Asked ? std::clamp(std::atoi(Asked), 1, 1'000'000) : GDefaultRandomPrograms;
	return std::max(1, All * Percent / 100);
}

/** The kernel that a program runs as: in turns those of each lane count, and in double. */
struct FRandomForm
{
	explicit FRandomForm(uint32_t Seed)
	{
		const std::vector<int32_t> Counts = GetLaneCounts();
		const size_t Turn = Seed % (Counts.size() + 1);
		bDouble = Turn == Counts.size();
		Lanes = bDouble ? 0 : Counts[Turn];
	}

	std::string GetName() const { return bDouble ? "double" : std::to_string(Lanes) + " lanes"; }

	bool bDouble = false;
	int32_t Lanes = 0;
};

} // namespace Drydock::Test
