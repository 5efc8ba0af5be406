// `drydock hazards` says what a pass of a plugin makes of NaN, infinities, denormals and the like.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Hazards/HazardPictures.h"
#include "ProgramTestUtils.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;

namespace
{

constexpr int Width = 16; // of FProgramFolder::WriteFrame
constexpr int Height = 8;

class HazardsOfAPass : public testing::Test
{
protected:
	HazardsOfAPass() { Folder.WriteFrame("frame.json", ", \"camera\": {\"Settings\": {\"BloomIntensity\": 0}}"); }

	FOutcome Call(const std::string& Plugin, const std::string& More) const
	{
		return Folder.Call("hazards frame.json --plugin " DRYDOCK_TEST_BINARY_DIR "/lib/lib" + Plugin + ".so " + More);
	}

	/** Findings by hazard. */
	std::map<std::string, nlohmann::json> Find(const std::string& Plugin, const std::string& More) const
	{
		const FOutcome Outcome = Call(Plugin, More + " --json");
		EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
		std::map<std::string, nlohmann::json> Found;
		const nlohmann::json Report = nlohmann::json::parse(Outcome.Printed.substr(Outcome.Printed.find('{')));
		for (const nlohmann::json& Finding : Report.at("passes").at(0).at("hazards"))
		{
			Found[Finding.at("hazard")] = Finding;
		}
		return Found;
	}

	const FProgramFolder Folder{"hazards"};
};

} // namespace

TEST_F(HazardsOfAPass, APassThatHandsOnItsInputSpreadsNothing)
{
	auto Found = Find("BrokenPromises", "--pass BrokenPromises");
	for (const char* Bad : {"NaN", "+Inf", "-Inf", "1e30"})
	{
		EXPECT_EQ(1, Found.at(Bad).at("changed")) << Bad;
		EXPECT_EQ(0, Found.at(Bad).at("reach")) << Bad;
	}
	EXPECT_EQ(1, Found.at("NaN").at("nan"));
	EXPECT_EQ(1, Found.at("+Inf").at("infinite"));
	EXPECT_EQ(1, Found.at("1e30").at("infinite")); // stored as half
	EXPECT_EQ(Width * Height, Found.at("65504").at("pixels"));
	EXPECT_EQ(65504, Found.at("65504").at("least"));
	EXPECT_EQ("finite: the bits of the input", Found.at("black").at("says"));
	EXPECT_EQ(0, Found.at("negative").at("nan"));
	EXPECT_GT(Found.at("negative").at("negative"), 0);
}

TEST_F(HazardsOfAPass, TheMeanOfFourTexelsReachesItsNeighbours)
{
	auto Found = Find("FourTaps", "--pass 'FourTaps*'");
	EXPECT_GT(Found.at("NaN").at("nan"), 1);
	EXPECT_GE(Found.at("NaN").at("reach"), 1);
	EXPECT_EQ(0, Found.at("constant").at("nan"));
}

TEST_F(HazardsOfAPass, ParametersAreHazardsToo)
{
	auto Found = Find("BrokenPromises", "--set r.BrokenPromises=5 --pass BrokenPromises");
	// Left of Middle the picture is halved: with Middle 0 and -1 it is the noise, with 1e6 half of it everywhere.
	EXPECT_EQ("finite: the bits of the input", Found.at("Middle = 0").at("says"));
	EXPECT_EQ("finite: the bits of the input", Found.at("Middle = -1").at("says"));
	const double Most = Found.at("Middle = 0").at("most");
	EXPECT_EQ(0.5 * Most, Found.at("Middle = 1e+06").at("most"));
}

TEST_F(HazardsOfAPass, PicturesAreWritten)
{
	const FOutcome Outcome = Call("BrokenPromises", "--pass BrokenPromises --out out");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(
		Outcome.Printed, HasSubstr("BrokenPromises  (FBrokenPromisesPS), hazards in place of Source, 16 x 8\n"));
	EXPECT_TRUE(std::filesystem::exists(Folder.Path / "out/hazards/NaN.png"));
	EXPECT_TRUE(std::filesystem::exists(Folder.Path / "out/hazards.json"));
}

TEST_F(HazardsOfAPass, AMisspeltPassIsNamed)
{
	const FOutcome Outcome = Call("BrokenPromises", "--pass BrokenPromise");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("matches 'BrokenPromise'; did you mean BrokenPromises?"));
	EXPECT_THAT(
		Call("BrokenPromises", "--pass BrokenPromises --input Sourc").Printed, HasSubstr("did you mean Source?"));
}

TEST(HazardPictures, HoldWhatTheySay)
{
	using namespace Drydock;
	const std::vector<FHazardPicture> NaN = MakeHazardPictures(EHazard::NaN, 8, 4, 3, 2);
	ASSERT_EQ(1u, NaN.size());
	EXPECT_TRUE(std::isnan(NaN[0].Picture.Get(3, 2, 0)));
	EXPECT_EQ(1.0, NaN[0].Picture.Get(3, 2, 3));
	EXPECT_TRUE(std::isfinite(NaN[0].Clean.Get(3, 2, 0)));
	EXPECT_EQ(NaN[0].Clean.Get(4, 2, 1), NaN[0].Picture.Get(4, 2, 1));
	const std::vector<FHazardPicture> Moving = MakeHazardPictures(EHazard::MovingHotPixel, 8, 4, 3, 2);
	ASSERT_EQ(11u, Moving.size());
	for (const FHazardPicture& Step : Moving)
	{
		EXPECT_DOUBLE_EQ(16.0, Step.Picture.Get(3, 2, 0) + Step.Picture.Get(4, 2, 0));
	}
	EXPECT_TRUE(MakeHazardPictures(EHazard::EqualPriorities, 8, 4, 3, 2).empty());
}
