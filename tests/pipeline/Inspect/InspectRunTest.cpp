// `drydock run` with its looks inside shaders, as a user types them: values as pictures, coverage, cost, prints, and
// the line that a NaN comes from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "ProgramTestUtils.h"

#include <cmath>
#include <sstream>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr int Width = 6;
constexpr int Height = 5;

class InspectRun : public testing::Test
{
protected:
	InspectRun()
	{
		const Drydock::FImage Scene{Width, Height, 3, std::vector<double>(Width * Height * 3, 0.5)};
		Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
		Folder.Write(
			"faults.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})");
	}

	FOutcome Run(int Fault, const std::string& Options) const
	{
		return Folder.Call("run faults.json --plugin " DRYDOCK_TEST_BINARY_DIR
						   "/lib/libPlantedFaults.so --out out --set r.PlantedFaults=" +
						   std::to_string(Fault) + " " + Options);
	}

	const FProgramFolder Folder{"inspect"};
};

TEST_F(InspectRun, NaNOfAPassIsTracedToItsLineUnasked)
{
	const FOutcome Outcome = Run(1, "");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("DD4001"));
	EXPECT_THAT(Outcome.Printed,
		HasSubstr("PlantedFaults.usf:17: warning DD4010 at pass PlantedFaults, FPlantedFaultsPS, which writes "
				  "PlantedFaults: nan: 0 / 0 is NaN, first of 10 at (0, 0): return Sum / Weight;"));
}

TEST_F(InspectRun, NaNThatFailsTheRunIsTracedAsWell)
{
	const FOutcome Outcome = Run(2, "--set r.Drydock.NonFinite=2");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("DD4002"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("PlantedFaults.usf:36: warning DD4010"));
}

TEST_F(InspectRun, SoundRunsAreNotLookedAt)
{
	const FOutcome Outcome = Run(0, "");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, Not(HasSubstr("DD40")));
	EXPECT_FALSE(std::filesystem::exists(Folder.Path / "out" / "inspect"));
}

TEST_F(InspectRun, ChecksDrawTheirPixels)
{
	const FOutcome Outcome = Run(3, "--check overflow");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	Drydock::FImageFile Mask((Folder.Path / "out/inspect/01.PlantedFaults.PlantedFaults_usf.62.overflow.png").string());
	ASSERT_EQ(Width, Mask.GetWidth());
	const std::vector<float> Values = Mask.Read({0})[0];
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		EXPECT_EQ(Pixel % Width == 3 ? 1.0f : 0.0f, Values[size_t(Pixel)]) << Pixel;
	}
}

TEST_F(InspectRun, ShowsAValueAsAPicture)
{
	const FOutcome Outcome = Run(3, "--show PlantedFaults.usf:40:Color --show PlantedFaults.usf:36");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(
		Outcome.Printed, HasSubstr("PlantedFaults.usf:40 Color in PlantedFaults: from 0.5 to 70000, of 30 of 30 "
								   "pixels -> inspect/01.PlantedFaults.PlantedFaults_usf.40.Color.png"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("PlantedFaults.usf:36 Color in PlantedFaults: from 0 to 0, of 0 of 30"));
	Drydock::FImageFile Values((Folder.Path / "out/inspect/01.PlantedFaults.PlantedFaults_usf.40.Color.exr").string());
	const int Green = Values.FindChannel("G");
	ASSERT_GE(Green, 0);
	const std::vector<float> Column = Values.Read({Green})[0];
	EXPECT_EQ(70000.0f, Column[3]);
	EXPECT_EQ(0.5f, Column[2]);
	Drydock::FImageFile Never((Folder.Path / "out/inspect/02.PlantedFaults.PlantedFaults_usf.36.Color.exr").string());
	EXPECT_TRUE(std::isnan(Never.Read({0})[0][0]));
}

TEST_F(InspectRun, CoverageNamesLinesThatNeverRan)
{
	const FOutcome Outcome = Run(2, "--coverage --passes PlantedFaults");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("  line 40 never ran: Color.g = Pixel.x == 3 ? 70000 : Color.g;\n"));
	EXPECT_THAT(Outcome.Printed, Not(HasSubstr("line 36 never ran")));
	std::stringstream Text;
	Text << std::ifstream(Folder.Path / "out/inspect/coverage.txt").rdbuf();
	EXPECT_THAT(Text.str(), HasSubstr("          30  100.0 %     36 | Color.r = pow(0.01 - Pixel.y, 2.2);\n"));
}

TEST_F(InspectRun, CostCountsTaps)
{
	const FOutcome Outcome = Run(1, "--cost --pass FPlantedFaultsPS");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	Drydock::FImageFile Cost((Folder.Path / "out/inspect/01.PlantedFaults.cost.exr").string());
	const int Taps = Cost.FindChannel("taps");
	ASSERT_GE(Taps, 0);
	EXPECT_EQ(std::vector<float>(Width * Height, 4.0f), Cost.Read({Taps})[0]) << "one load, and three of the loop";
}

TEST_F(InspectRun, PrintsWhatShadersSay)
{
	const FOutcome Outcome = Run(9, "--print --at 3,2");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("PlantedFaults (3, 2) PlantedFaults.usf:65: green 0.50 at (3, 2)\n"));
	const FOutcome All = Run(9, "--print --check assert");
	EXPECT_THAT(All.Printed, HasSubstr("PlantedFaults (5, 4) PlantedFaults.usf:65: green 0.50 at (5, 4)\n"));
	EXPECT_THAT(All.Printed, HasSubstr("assert: Pixel.x < 4 does not hold: Pixel = (4, 0), first of 10 at (4, 0)"));
	const FOutcome Engines = Run(11, "--print");
	EXPECT_THAT(Engines.Printed, HasSubstr("PlantedOverlap (1, 1) PlantedOverlap.usf:16: Size (6, 5) \n"));
	EXPECT_THAT(Engines.Printed, Not(HasSubstr("PlantedOverlap (0, 0)")));
	const FOutcome None = Run(9, "--print --pass Tonemap*");
	EXPECT_THAT(None.Printed, HasSubstr("DD4012"));
}

TEST_F(InspectRun, MistakesAreNamedBeforeTheRun)
{
	const FOutcome Place = Run(0, "--show PlantedFaults.usf");
	EXPECT_EQ(2, Place.ExitCode);
	EXPECT_THAT(Place.Printed, HasSubstr("expected FILE.usf:LINE"));
	const FOutcome Line = Run(0, "--show PlantedFaults.usf:24 --show Nowhere.usf:3");
	EXPECT_EQ(2, Line.ExitCode);
	EXPECT_THAT(Line.Printed, HasSubstr("PlantedFaults.usf:24 computes no value; lines near it that do: "));
	EXPECT_THAT(
		Line.Printed, HasSubstr("no pass is made of Nowhere.usf; those that ran are made of PlantedFaults.usf"));
	EXPECT_FALSE(std::filesystem::exists(Folder.Path / "out" / "run.json"));
}

} // namespace
