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

constexpr int GDefaultRandomPrograms = 36;

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

/** Runs a program over X x Y threads or pixels as the kernel of its seed, by the interpreter with its functions and, of
 * floats, by the interpreter. Fill(Harness) gives it what it reads; FindDifference(A, B) says where two have other
 * results, "" where nowhere. */
template<typename FFill, typename FFindDifference>
void ExpectFormsAgree(uint32_t Seed, const std::string& Text, EShaderStage Stage, int32_t X, int32_t Y, FFill Fill,
	FFindDifference FindDifference)
{
	SCOPED_TRACE(Text);
	const FRandomForm Form(Seed);
	const std::string Entry = Stage == EShaderStage::Pixel ? "MainPS" : "MainCS";
	FShaderHarness Kernel(Text, Entry, Stage);
	Fill(Kernel);
	Kernel.Run(Form.Lanes, X, Y, 1, Form.bDouble);
	FShaderHarness Inspected(Text, Entry, Stage);
	Fill(Inspected);
	Inspected.RunInspected(X, Y, 1, Form.bDouble);
	EXPECT_EQ("", FindDifference(Kernel, Inspected))
		<< "seed " << Seed << ", " << Form.GetName() << ", with its functions";
	if (!Form.bDouble)
	{
		FShaderHarness Model(Text, Entry, Stage);
		Fill(Model);
		Model.RunModel(X, Y);
		EXPECT_EQ("", FindDifference(Kernel, Model)) << "seed " << Seed << ", " << Form.GetName();
	}
}

} // namespace Drydock::Test
