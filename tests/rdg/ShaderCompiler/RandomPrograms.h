// How many random programs to run, and each in which form: every program runs as one kernel, by the interpreter, and by
// the interpreter with its functions.
#pragma once

#include "ShaderHarness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace Drydock::Test
{

constexpr int GDefaultRandomPrograms = 60;

/** The seeds of a kind that has this share of all programs. DRYDOCK_RANDOM_PROGRAMS says how many those are,
 * DRYDOCK_RANDOM_FIRST the first of them, 0 unless told: runs that go on where another ends write no program twice
 * (docs/testing.md). */
inline auto RandomSeeds(int Percent)
{
	const auto Read = [](const char* Name, int Default, int Least)
	{
		const char* const Asked = std::getenv(Name);
		return Asked ? std::clamp(std::atoi(Asked), Least, 1'000'000) : Default;
	};
	const int First = Read("DRYDOCK_RANDOM_FIRST", 0, 0);
	const int Last = First + Read("DRYDOCK_RANDOM_PROGRAMS", GDefaultRandomPrograms, 1);
	const int FirstSeed = First * Percent / 100;
	return testing::Range(FirstSeed, std::max(FirstSeed + 1, Last * Percent / 100));
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
