// A pass that wrote again what it read is remarked on, with the reason where one can be known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

#include <nlohmann/json.hpp>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

class SilentPass : public testing::Test
{
protected:
	/** What a run of the frame with a plugin, or a pass of the config, prints. */
	FOutcome Run(const std::string& More, const std::string& Arguments = "") const
	{
		Folder.WriteFrame("frame.json", ", \"camera\": {\"Settings\": {\"BloomIntensity\": 0}}" + More);
		const FOutcome Outcome = Folder.Call("run frame.json --out out " + Arguments);
		EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
		return Outcome;
	}

	const FProgramFolder Folder{"silent"};
};

const std::string Broken = "--plugin " DRYDOCK_TEST_BINARY_DIR "/lib/libBrokenPromises.so --set r.BrokenPromises=";

} // namespace

TEST_F(SilentPass, APluginThatDoesNothingIsNamed)
{
	EXPECT_THAT(Run("", Broken + "0").Printed,
		HasSubstr(
			"note DD4004 at pass BrokenPromises: it wrote the same values as it read from SceneColor, bit for bit: its "
			"parameters leave every pixel as it is"));
	const nlohmann::json Report = nlohmann::json::parse(Folder.Read("out/run.json"));
	bool bFound = false;
	for (const nlohmann::json& Pass : Report.at("passes"))
	{
		bFound = bFound || (Pass.at("name") == "BrokenPromises" && Pass.at("sameAs") == "SceneColor");
		EXPECT_EQ(Pass.at("name") == "BrokenPromises", Pass.contains("sameAs")) << Pass.at("name");
	}
	EXPECT_TRUE(bFound);
}

TEST_F(SilentPass, OneThatChangesAPixelIsNot)
{
	EXPECT_THAT(Run("", Broken + "5").Printed, Not(HasSubstr("DD4004")));
}

TEST_F(SilentPass, ACallbackThatReturnsItsInputIsNamed)
{
	const std::string Gate = "--plugin " DRYDOCK_TEST_BINARY_DIR "/lib/libGate.so --set r.Gate.Enable=";
	EXPECT_THAT(
		Run("", Gate + "0").Printed, HasSubstr("its callback at MotionBlur added no pass and returned its input"));
	EXPECT_THAT(Run("", Gate + "1").Printed, Not(HasSubstr("DD2065")));
}

TEST_F(SilentPass, ExplainGivesPluginsARowAndPassesTheirValues)
{
	Folder.WriteFrame("frame.json", "");
	const std::string Common = "explain frame.json " + Broken + "5 ";
	EXPECT_THAT(Folder.Call(Common).Printed, testing::ContainsRegex("\nplugin libBrokenPromises.so +yes +1 "));
	const std::string Pass = Folder.Call(Common + "--pass BrokenPromises").Printed;
	EXPECT_THAT(Pass, HasSubstr("  effect   plugin libBrokenPromises.so\n"));
	EXPECT_THAT(Pass, HasSubstr("  values   Middle = (8, 4), Fault = 5\n"));
	EXPECT_THAT(Pass, HasSubstr("  begins   a render pass: "));
	EXPECT_THAT(Folder.Call(Common + "--effect 'plugin libBrokenPromises.so'").Printed, HasSubstr("BrokenPromises"));
	const std::string Graph = Folder.Call("graph frame.json " + Broken + "5").Printed;
	EXPECT_THAT(Graph, HasSubstr("        values   Middle = (8, 4), Fault = 5\n"));
	EXPECT_THAT(Graph, HasSubstr("        begins   a render pass: "));
}
