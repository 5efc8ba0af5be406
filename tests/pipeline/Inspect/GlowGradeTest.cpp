// Ten mistakes of a plugin (tests/plugins/GlowGrade), each found with its line by at most two commands, as a user types
// them; and the tools that look for places: probe, trace, prove, hazards, check.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Hazards/HazardCapture.h"
#include "ProgramTestUtils.h"
#include "ThreadRuns.h"

#include <algorithm>
#include <cmath>
#include <regex>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr int Width = 160;
constexpr int Height = 96;

class GlowGrade : public testing::Test
{
protected:
	GlowGrade()
	{
		Drydock::FImage Scene{Width, Height, 4, {}};
		for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
		{
			const int X = Pixel % Width, Y = Pixel / Width;
			const double Lamp = (X - 40) * (X - 40) + (Y - 30) * (Y - 30) < 60 ? 4.0 : 0.0;
			// Red, green, blue; and depth from 1 m to 25 m.
			const double Values[] = {
				0.1 + Lamp, 0.2 + 0.3 * X / Width + 0.5 * Lamp, 0.1 + 0.5 * Y / Height, 1.0 + 24.0 * Y / Height};
			Scene.Values.insert(Scene.Values.end(), std::begin(Values), std::end(Values));
		}
		Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B", "depth.Z"});
		Folder.Write("glow.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})");
	}

	FOutcome Call(const std::string& Verb, int Fault, const std::string& Options) const
	{
		return Folder.Call(
			Verb + " glow.json --plugin " DRYDOCK_TEST_BINARY_DIR "/lib/libGlowGrade.so --set r.GlowGrade.Fault=" +
			std::to_string(Fault) + " " + Options);
	}

	const FProgramFolder Folder{"glow"};
};

TEST_F(GlowGrade, NothingIsFoundWhereNothingIsWrong)
{
	const FOutcome Run = Call("run", 0, "--out out --check all --pass 'Glow*'");
	EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
	EXPECT_THAT(Run.Printed, Not(HasSubstr("DD")));
	const FOutcome Proven = Call("prove", 0, "");
	EXPECT_EQ(0, Proven.ExitCode) << Proven.Printed;
	EXPECT_THAT(Proven.Printed, Not(HasSubstr("DIFFERS")));
}

TEST_F(GlowGrade, Fault1IsWhatProbeAndTraceShow)
{
	EXPECT_THAT(Call("probe", 1, "40,30 --pass GlowCompose").Printed, HasSubstr("GlowTexture 20,15 of 80 x 48 = ("));
	const FOutcome Traced = Call("trace", 1, "--pass GlowCompose --pixel 40,30");
	EXPECT_THAT(Traced.Printed, ContainsRegex("sample GlowTexture .*\n.*\n *[0-9]+ +Light = Light.bgr;\n *Light = "));
}

TEST_F(GlowGrade, Fault2IsNotSymmetric)
{
	const FOutcome Proven = Call("prove", 2, "--only Mirrored");
	EXPECT_EQ(0, Proven.ExitCode) << "an effect may have a direction";
	EXPECT_THAT(Proven.Printed, HasSubstr("DIFFERS in one pass, which may be meant"));
	EXPECT_THAT(Proven.Printed, HasSubstr("first in pass GlowCompose, FGlowComposePS, of libGlowGrade.so"));
	EXPECT_THAT(Proven.Printed, HasSubstr("likely: samples are off by a part of a texel"));
	EXPECT_THAT(Call("trace", 2, "--pass GlowCompose --pixel 40,30").Printed,
		ContainsRegex("GlowUV \\+= 0.5 \\* Glow_ExtentInverse;\n"));
}

TEST_F(GlowGrade, Fault3EncodesMidGreyOnceMore)
{
	const FOutcome Wrong = Call("hazards", 3, "--pass GlowGrade");
	EXPECT_THAT(Wrong.Printed, ContainsRegex("mid grey +0.5 0.5 0.5 +becomes 0.7.*: as sRGB encodes it: once more"));
	EXPECT_THAT(Call("hazards", 0, "--pass GlowGrade").Printed, ContainsRegex("mid grey .*: as it was"));
}

TEST_F(GlowGrade, Fault4IsNamedThoughMinHidesIt)
{
	const FOutcome Run = Call("run", 4, "--out out --check nan");
	EXPECT_THAT(Run.Printed, ContainsRegex("GlowGrade.usf:23: warning DD4010 at pass GlowSetup, FGlowSetupPS: nan: "
										   "pow\\(-.*\\) is NaN.*float Weight = min\\(pow\\(Over, 0.8\\), 1.0\\);"));
	EXPECT_THAT(Call("run", 4, "--out out").Printed, Not(HasSubstr("DD40"))) << "no picture shows it";
}

TEST_F(GlowGrade, Fault5IsInTheTableOfRanges)
{
	const FOutcome Run = Call("run", 5, "--out out --ranges --pass GlowCompose");
	EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
	EXPECT_THAT(Run.Printed, ContainsRegex("GlowGrade.usf:5[0-9] +Fog +-0.1.* 1\\.[0-9]+ +float Fog = "));
	EXPECT_THAT(Call("run", 0, "--out out --ranges --pass GlowCompose").Printed,
		ContainsRegex("GlowGrade.usf:5[0-9] +Fog +0 +1 +float Fog = saturate"));
}

TEST_F(GlowGrade, Fault6IsNamedWithoutBeingAsked)
{
	EXPECT_THAT(Call("run", 6, "--out out").Printed,
		ContainsRegex("GlowGrade.usf:6[0-9]:.*warning.*X4000: use of potentially uninitialized variable 'Near'"));
}

TEST_F(GlowGrade, Fault7IsARace)
{
	EXPECT_THAT(Call("run", 7, "--out out --check race").Printed,
		ContainsRegex("GlowBlur.usf:[0-9]+: warning DD4010 at pass GlowBlurX, .*race: a read of Tile\\[.*no barrier is "
					  "between"));
}

TEST_F(GlowGrade, Fault8DiffersInALargerTexture)
{
	const FOutcome Proven = Call("prove", 8, "--only OffsetRect");
	EXPECT_EQ(1, Proven.ExitCode) << Proven.Printed;
	EXPECT_THAT(Proven.Printed, HasSubstr("first in pass GlowCompose, FGlowComposePS"));
	EXPECT_THAT(Proven.Printed, HasSubstr("a shader takes its place from the texture's extent"));
}

TEST_F(GlowGrade, Fault9DependsOnPreExposure)
{
	const FOutcome Proven = Call("prove", 9, "--only PreExposure");
	EXPECT_EQ(1, Proven.ExitCode) << Proven.Printed;
	EXPECT_THAT(Proven.Printed, HasSubstr("first in pass GlowSetup, FGlowSetupPS, of libGlowGrade.so"));
	EXPECT_THAT(Proven.Printed, HasSubstr("multiplies by the pre-exposure once more"));
	EXPECT_EQ(0, Call("prove", 0, "--only PreExposure").ExitCode);
}

TEST_F(GlowGrade, Fault10IsALineOfTheTrace)
{
	EXPECT_THAT(Call("trace", 10, "--pass GlowCompose --pixel 40,90").Printed,
		ContainsRegex("FogColor = \\(0.025, 0.03, 0.0375\\)\n(.*\n)* *[0-9]+ +FogColor \\*= Veil;\n *FogColor = "
					  "\\(0.00625, 0.0075, 0.009375\\)"));
}

TEST_F(GlowGrade, ProbeTakesTheThreadThatStoredTheTexel)
{
	// GlowBlurY: the threads of a group go down a column, so that thread (15, 20) stores to texel (20, 15).
	const FOutcome Columns = Call("probe", 0, "40,30 --pass GlowBlurY");
	EXPECT_THAT(Columns.Printed, HasSubstr("   thread 15,20 stored to OutGlow 20,15\n"));
	// Taps are 4 texels up and down: elements 15 to 23 of the group's tile, whose first is texel -4.
	for (int Tap = 0; Tap < 9; ++Tap)
	{
		EXPECT_THAT(Columns.Printed,
			ContainsRegex("reads Tile\\[" + std::to_string(15 + Tap) + "\\] = \\(.*\\), put there by thread " +
						  std::to_string(15 + Tap) + ",20 in line 25\n"));
	}
	EXPECT_THAT(Columns.Printed, Not(HasSubstr("Tile[24]")));
	const FOutcome Rows = Call("probe", 0, "40,30 --pass GlowBlurX");
	EXPECT_THAT(Rows.Printed, HasSubstr("   thread 20,15 stored to OutGlow 20,15\n"));
	const FOutcome Json = Call("probe", 0, "40,30 --pass GlowBlurY --json");
	EXPECT_THAT(Json.Printed, HasSubstr(R"("thread": [15, 20, 0])"));
}

TEST_F(GlowGrade, TraceTakesATexelOrAThread)
{
	const FOutcome Pixel = Call("trace", 0, "--pass GlowBlurY --pixel 20,15");
	EXPECT_THAT(Pixel.Printed, HasSubstr("thread 15,20, which stored to OutGlow 20,15\n"));
	EXPECT_THAT(Pixel.Printed, ContainsRegex("load Tile\\[15\\] = .*\\[put there by thread 15,20 in line 25\\]"));
	const FOutcome Thread = Call("trace", 0, "--pass GlowBlurY --thread 15,20");
	EXPECT_THAT(Thread.Printed, HasSubstr("thread 15,20\n"));
	EXPECT_EQ(Pixel.Printed.substr(Pixel.Printed.find('\n')), Thread.Printed.substr(Thread.Printed.find('\n')));
	const FOutcome Outside = Call("trace", 0, "--pass GlowBlurY --pixel 90,15");
	EXPECT_EQ(2, Outside.ExitCode);
	EXPECT_THAT(Outside.Printed, HasSubstr("no thread of it stores there"));
	const FOutcome Both = Call("trace", 0, "--pass GlowBlurY --pixel 20,15 --thread 1,1");
	EXPECT_EQ(2, Both.ExitCode);
	EXPECT_THAT(Both.Printed, HasSubstr("expected one of --pixel"));
}

TEST_F(GlowGrade, ACheckLooksAtASampleUnlessToldOtherwise)
{
	Drydock::FImage Large{960, 540, 4, std::vector<double>(960 * 540 * 4, 0.25)};
	Drydock::WriteExr((Folder.Path / "scene.exr").string(), Large, {"R", "G", "B", "depth.Z"});
	const std::string Options = "--out out --check nan --pass GlowSetup ";
	const std::string Printed = Call("run", 4, Options).Printed;
	EXPECT_TRUE(
		std::regex_search(Printed, std::regex("is NaN, first of ([0-9]+) of \\1 threads of 129600 at \\(0, 0\\)")))
		<< Printed;
	EXPECT_THAT(
		Call("run", 4, Options + "--check-all-threads").Printed, HasSubstr("is NaN, first of 129600 at (0, 0)"));
}

TEST_F(GlowGrade, WhatIsStatedAsNoFaultIsNotReported)
{
	// Far from the curve's toe an exponential overflows (Inspect/StatedFindings.h).
	const FOutcome Run =
		Folder.Call("run glow.json --out out --check all --check-all-threads --pass 'Tonemap*,*ColorLUT*'");
	EXPECT_THAT(Run.Printed, Not(HasSubstr("FilmCurve.ush")));
}

TEST(SampledThreads, AreWholeBlocksSpreadOverAllRowsAndTheSameEveryTime)
{
	Drydock::FShaderReflection Shader;
	Shader.Stage = Drydock::EShaderStage::Pixel;
	const Drydock::FKernelTile Whole = {0, 0, 0, 960, 540, 1};
	const auto Threads = Drydock::SampleThreads(Whole, Shader, 4096);
	EXPECT_GT(Threads.size(), 3000u);
	EXPECT_LT(Threads.size(), 5000u);
	std::set<int32_t> Columns, Rows;
	for (const std::array<int32_t, 3>& At : Threads)
	{
		Columns.insert(At[0] / 8);
		Rows.insert(At[1] / 8);
	}
	EXPECT_GT(Columns.size(), 30u);
	EXPECT_GT(Rows.size(), 30u);
	EXPECT_EQ((std::array<int32_t, 3>{0, 0, 0}), Threads.front());
	EXPECT_EQ((std::array<int32_t, 3>{959, 539, 0}), Threads.back());
	EXPECT_EQ(Threads, Drydock::SampleThreads(Whole, Shader, 4096));
	EXPECT_TRUE(Drydock::SampleThreads({0, 0, 0, 64, 64, 1}, Shader, 4096).empty()) << "all of them";
}

TEST(Tones, AreNamedByWhatBecameOfThem)
{
	using Drydock::DescribeTone;
	EXPECT_EQ("as it was", DescribeTone({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}));
	EXPECT_EQ("as sRGB encodes it: once more?", DescribeTone({0.5, 0.5, 0.5}, {0.7354, 0.7354, 0.7354}));
	EXPECT_EQ("as sRGB decodes it: once too often?", DescribeTone({0.5, 0.5, 0.5}, {0.2140, 0.2140, 0.2140}));
	EXPECT_EQ("red and blue are swapped", DescribeTone({0.75, 0.5, 0.25}, {0.25, 0.5, 0.75}));
	EXPECT_EQ("channels are swapped", DescribeTone({0.75, 0.5, 0.25}, {0.5, 0.75, 0.25}));
	EXPECT_EQ("squared: multiplied by itself?", DescribeTone({0.75, 0.5, 0.25}, {0.5625, 0.25, 0.0625}));
	EXPECT_EQ("grey", DescribeTone({0.75, 0.5, 0.25}, {0.5, 0.5, 0.5}));
	EXPECT_EQ("times 1.5", DescribeTone({0.75, 0.5, 0.25}, {1.125, 0.75, 0.375}));
	EXPECT_EQ("", DescribeTone({0.75, 0.5, 0.25}, {0.1, 0.9, 0.3}));
}

} // namespace
