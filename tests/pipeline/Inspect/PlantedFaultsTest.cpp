// Mistakes planted in a plugin's shader (tests/plugins/PlantedFaults), each found by one command, as a user types it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

#include <sstream>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr int Width = 6;
constexpr int Height = 5;

/** The page's table of mistakes has the answer. */
void ExpectQuoted(const std::string& Answer)
{
	std::stringstream Page;
	Page << std::ifstream(DRYDOCK_TEST_SOURCE_DIR "/docs/see-inside.md").rdbuf();
	EXPECT_THAT(Page.str(), HasSubstr(Answer));
}

class PlantedFaults : public testing::Test
{
protected:
	PlantedFaults()
	{
		const Drydock::FImage Scene{Width, Height, 3, std::vector<double>(Width * Height * 3, 0.5)};
		Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
		Folder.Write(
			"faults.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})");
	}

	std::string Common(int Fault) const
	{
		return "faults.json --plugin " DRYDOCK_TEST_BINARY_DIR "/lib/libPlantedFaults.so --set r.PlantedFaults=" +
			   std::to_string(Fault) + " ";
	}

	/** The messages of DD4010, from the name of the shader's file on. */
	std::vector<std::string> Check(int Fault, const std::string& Checks) const
	{
		const FOutcome Outcome = Folder.Call("run " + Common(Fault) + "--out out --check " + Checks);
		EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
		std::vector<std::string> Found;
		std::istringstream Lines(Outcome.Printed);
		for (std::string Line; std::getline(Lines, Line);)
		{
			if (Line.find("DD4010") != std::string::npos)
			{
				const size_t File = Line.find(".usf:");
				Found.push_back(Line.substr(File == std::string::npos ? 0 : Line.rfind('/', File) + 1));
			}
		}
		return Found;
	}

	const FProgramFolder Folder{"planted"};
};

/** "PlantedFaults.usf:17: warning DD4010 at pass PlantedFaults, FPlantedFaultsPS: nan: ...", which the page quotes. */
std::vector<std::string> Expect(int Line, const std::string& Text)
{
	const std::string File = "PlantedFaults.usf:" + std::to_string(Line);
	ExpectQuoted("`" + File + "`: `" + Text + "`");
	return {File + ": warning DD4010 at pass PlantedFaults, FPlantedFaultsPS: " + Text};
}

TEST_F(PlantedFaults, NoneIsClean)
{
	EXPECT_EQ(std::vector<std::string>{}, Check(0, "all --pass PlantedFaults"));
}

TEST_F(PlantedFaults, ADivisionByNothingBehindALoop)
{
	EXPECT_EQ(Expect(17, "nan: 0 / 0 is NaN, first of 10 at (0, 0): return Sum / Weight;"), Check(1, "nan"));
}

TEST_F(PlantedFaults, ThePowerOfANegativeNumber)
{
	EXPECT_EQ(Expect(36, "nan: pow(-0.99, 2.2) is NaN, first of 24 at (0, 1): Color.r = pow(0.01 - Pixel.y, 2.2);"),
		Check(2, "nan"));
}

TEST_F(PlantedFaults, MoreThanAHalfHolds)
{
	EXPECT_EQ(Expect(62, "overflow: 70000 is stored to SV_Target0 (green), whose RGBA16_FLOAT makes it infinite, first "
						 "of 5 at (3, 0): OutColor = Color;"),
		Check(3, "overflow"));
}

TEST_F(PlantedFaults, AReadOutsideATexture)
{
	EXPECT_EQ(
		Expect(44, "bounds: a read of Source at (6, 0), which is 6 x 5; it gives 0, first of 5 at (5, 0): Color = "
				   "Source.Load(int3(Pixel + int2(1, 0), 0));"),
		Check(4, "bounds"));
}

TEST_F(PlantedFaults, AnIndexOutsideAnArray)
{
	EXPECT_EQ(
		Expect(48, "bounds: element 4 of an array that has 4; the nearest is taken, first of 6 at (0, 4): Color.b "
				   "+= Table[Pixel.y];"),
		Check(5, "bounds"));
}

TEST_F(PlantedFaults, AVariableThatNothingWrote)
{
	EXPECT_EQ(Expect(52, "uninit: 'Never' is used before it is written (component 0), first of 30 at (0, 0): Color.rgb "
						 "+= 0.5 * Never;"),
		Check(6, "uninit"));
}

TEST_F(PlantedFaults, NegativeLight)
{
	EXPECT_EQ(Expect(62, "negative: -0.5 is stored to SV_Target0 (red), first of 30 at (0, 0): OutColor = Color;"),
		Check(7, "negative"));
}

TEST_F(PlantedFaults, ALevelThatATextureDoesNotHave)
{
	EXPECT_EQ(
		Expect(70, "bounds: a read of Source at (0, 0), mip 1, which it does not have; it gives 0, first of 30 at "
				   "(0, 0): OutColor = Source.Load(int3(Pixel, 1));"),
		Check(10, "bounds"));
}

TEST_F(PlantedFaults, AStoreThatOverlapsItsNeighbour)
{
	ExpectQuoted(
		"`PlantedOverlap.usf:20`: `overlap: a store to Out at (1, 0), where thread (0, 0) stores another value in "
		"line 23, first of 25 at (1, 0): Out[Id] = Color;`");
	EXPECT_EQ(
		(std::vector<std::string>{
			"PlantedOverlap.usf:20: warning DD4010 at pass PlantedOverlap, FPlantedOverlapCS: overlap: a store to Out "
			"at (1, 0), where thread (0, 0) stores another value in line 23, first of 25 at (1, 0): Out[Id] = Color;"}),
		Check(11, "overlap"));
}

TEST_F(PlantedFaults, SwappedChannelsAreWhereTwoRunsPart)
{
	Drydock::FImage Scene{Width, Height, 3, std::vector<double>(Width * Height * 3)};
	for (size_t i = 0; i < Scene.Values.size(); ++i)
	{
		Scene.Values[i] = 0.25 * static_cast<double>(1 + i % 3);
	}
	Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
	const FOutcome Outcome = Folder.Call("probe " + Common(8) + "2,3 --against r.PlantedFaults=0");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed,
		HasSubstr(
			"\nPlantedFaults  (FPlantedFaultsPS)\n"
			"   reads Source 2,3 = (0.25, 0.5, 0.75, 1) (RGBA16_FLOAT) at the pixel, read: 2,3 = (0.25, 0.5, 0.75, 1)\n"
			"   SV_Target0 2,3 = (0.75, 0.5, 0.25, 1) (RGBA16_FLOAT)\n"
			"   < here they part; against it SV_Target0 2,3 = (0.25, 0.5, 0.75, 1)"));
}

TEST_F(PlantedFaults, TheProbeShowsTheTexelAtThePixelInATextureOfAnotherSize)
{
	Drydock::FImage Scene{8, 4, 3, std::vector<double>(8 * 4 * 3)};
	for (size_t i = 0; i < Scene.Values.size(); ++i)
	{
		const size_t X = i / 3 % 8, Y = i / 24;
		Scene.Values[i] = static_cast<double>(X / 2 + 4 * (Y / 2)); // alike in each square of 2 x 2
	}
	Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
	Folder.Write("half.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0,
		"UnityBloomIntensity": 1, "UnityBloomThreshold": 0, "UnityBloomIterations": 1, "UnityBloomDownSample": 2}}})");
	const FOutcome Outcome = Folder.Call("probe half.json 5,2 --pass 'UnityBloom*'");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("pixel 5,2 of 8 x 4\n"));
	// 5 of 8 columns is 2 of 4, and 2 of 4 rows is 1 of 2: the square of the value 2 + 4.
	EXPECT_THAT(Outcome.Printed, HasSubstr("Texture 5,2 = (6, 6, 6, 1) (RGBA16_FLOAT) at the pixel, read: "));
	EXPECT_THAT(Outcome.Printed, HasSubstr("Texture 2,1 of 4 x 2 = (6, 6, 6, "));
	const FOutcome Json = Folder.Call("probe half.json 5,2 --json --pass 'UnityBloom*'");
	EXPECT_THAT(
		Json.Printed, HasSubstr(R"("atPixel": {"width": 4, "height": 2, "format": "RGBA16_FLOAT", "x": 2, "y": 1)"));
}

TEST_F(PlantedFaults, ThePageQuotesTheProbe)
{
	ExpectQuoted("`< here they part; against it SV_Target0 2,3 = (0.25, 0.5, 0.75, 1)`");
}

TEST_F(PlantedFaults, ATraceShowsTheLoopThatAddsNothing)
{
	const FOutcome Outcome = Folder.Call("trace " + Common(1) + "--pass PlantedFaults --pixel 0,2");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("call Blur"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("Weight += Tap;\n"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("Weight = 0\n"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("Blur returns (NaN, NaN, NaN, NaN)"));
	EXPECT_THAT(Outcome.Printed, Not(HasSubstr("pow(")));
}

TEST_F(PlantedFaults, ParametersOnTheStackAreAnError)
{
	const FOutcome Outcome = Folder.Call("run " + Common(12) + "--out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed,
		testing::ContainsRegex("PlantedFaults.cpp:[0-9]+: error DD2018 at plugin libPlantedFaults.so, .*, pass "
							   "PlantedFaults: the parameters lie on the stack of the callback at MotionBlur of "
							   "extension FPlantedFaultsExtension"));
}

TEST_F(PlantedFaults, ABufferOfOtherElementsIsAnError)
{
	const FOutcome Outcome = Folder.Call("run " + Common(13) + "--out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("DD6105"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("'Items' has elements of 16 bytes where it is read by"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("and the buffer PlantedItems was created with elements of 4"));
}

TEST_F(PlantedFaults, ThreadsGivenAsGroupsAreNoted)
{
	const FOutcome Outcome = Folder.Call("run " + Common(14) + "--out out");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed,
		HasSubstr("note DD2056 at shader class FPlantedCopyCS: the dispatch has 6 x 5 groups of 8 x 8 threads, and Out "
				  "has 6 x 5 texels, which 1 group covers"));
	EXPECT_THAT(Folder.Call("run " + Common(0) + "--out out").Printed, Not(HasSubstr("DD2056")));
}

TEST_F(PlantedFaults, APluginThatTakesNoPartIsNoted)
{
	const FOutcome Outcome = Folder.Call("run " + Common(15) + "--out out");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(
		Outcome.Printed, HasSubstr("note DD2076 at plugin libPlantedFaults.so: no extension of the plugin took part: "
								   "FPlantedFaultsExtension subscribed nothing, added no pass and changed no setting"));
	EXPECT_THAT(Folder.Call("run " + Common(0) + "--out out").Printed, Not(HasSubstr("DD2076")));
}

TEST_F(PlantedFaults, ShadersThatTheEngineWouldNotFindAreNoted)
{
	EXPECT_THAT(Folder.Call("run " + Common(0) + "--out out").Printed,
		HasSubstr(
			"the plugin does not map /Plugin/PlantedFaults, and the engine will not find /Plugin/PlantedFaults/"));
	// Gate maps its own.
	EXPECT_THAT(
		Folder.Call("run faults.json --out out --plugin " DRYDOCK_TEST_BINARY_DIR "/lib/libGlowGrade.so").Printed,
		Not(HasSubstr("DD2077")));
}

TEST_F(PlantedFaults, TexelsThatNothingWroteAreNamedWithTheirReader)
{
	Drydock::WriteExr((Folder.Path / "scene.exr").string(),
		Drydock::FImage{20, 12, 3, std::vector<double>(20 * 12 * 3, 0.5)}, {"R", "G", "B"});
	const FOutcome Outcome = Folder.Call("run " + Common(16) + "--out out");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	// 2 x 1 groups of 8 x 8 cover 16 x 8 of 20 x 12.
	EXPECT_THAT(Outcome.Printed, HasSubstr("warning DD4006 at pass "));
	EXPECT_THAT(
		Outcome.Printed, HasSubstr("the pass reads texels of PlantedFaults that nothing wrote: 112 of 20 x 12, the "
								   "first at (16, 0)"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("Its writer is PlantedCopy, of 2 x 1 groups of 8 x 8 threads."));
	const std::string First = Folder.Read("out/final.exr");
	Folder.Call("run " + Common(16) + "--out out");
	EXPECT_EQ(First, Folder.Read("out/final.exr")) << "such texels are 0";
	EXPECT_THAT(Folder.Call("run " + Common(0) + "--out out").Printed, Not(HasSubstr("DD4006")));
	const FOutcome Proven = Folder.Call("prove " + Common(16));
	EXPECT_EQ(1, Proven.ExitCode);
	EXPECT_THAT(Proven.Printed, HasSubstr("NOT REPEATABLE"));
	EXPECT_THAT(Proven.Printed, HasSubstr("OneThread"));
	EXPECT_THAT(Proven.Printed, HasSubstr("not asked: the frame is not repeatable"));
	EXPECT_THAT(Proven.Printed, Not(HasSubstr("DIFFERS")));
}

TEST_F(PlantedFaults, AMisspeltCheckIsNamed)
{
	const FOutcome Outcome = Folder.Call("run " + Common(0) + "--out out --check bonds");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("there is no check 'bonds'; did you mean bounds?"));
}

} // namespace
