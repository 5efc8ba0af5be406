// Arguments of `drydock run` that take the place of what the config says, or add to what is written: --engine, --plugin
// and --fingerprints.
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;

namespace
{

// Local exposure brings the bloom setup, of which engine 5.3 keeps the ramp at threshold -1.
const std::string Bloom =
	R"(, "volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1, "LocalExposureHighlightContrastScale": 0.5}}])";
const std::string SwapChannels = "'" DRYDOCK_TEST_BINARY_DIR "/lib/libSwapChannels.so'";

class RunArguments : public testing::Test
{
protected:
	/** Runs a config with Arguments into Out. */
	void Run(const std::string& Config, const std::string& Arguments, const std::string& Out) const
	{
		const FOutcome Outcome = Folder.Call("run " + Config + " " + Arguments + " --out " + Out);
		ASSERT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	}

	nlohmann::json GetReport(const std::string& Out) const
	{
		return nlohmann::json::parse(Folder.Read(Out + "/run.json"));
	}
	std::string GetPicture(const std::string& Out) const { return Folder.Read(Out + "/final.exr"); }

	/** "RESOURCE" of each executed pass, by its name, with the fingerprint. */
	std::map<std::string, nlohmann::json> GetWritten(const std::string& Out) const
	{
		std::map<std::string, nlohmann::json> Written;
		const nlohmann::json Report = GetReport(Out);
		for (const nlohmann::json& Pass : Report["passes"])
		{
			if (Pass.contains("written"))
			{
				Written[Pass["name"]] = Pass["written"];
			}
		}
		return Written;
	}

	const FProgramFolder Folder{"run_arguments"};
};

} // namespace

TEST_F(RunArguments, EngineTakesThePlaceOfTheConfigs)
{
	Folder.WriteFrame("four.json", Bloom + R"(, "engine": "5.4")");
	Folder.WriteFrame("three.json", Bloom + R"(, "engine": "5.3")");
	Run("four.json", "", "four");
	Run("four.json", "--engine 5.3", "argument");
	Run("three.json", "", "three");
	EXPECT_EQ("5.4", GetReport("four")["engine"]);
	EXPECT_EQ("5.3", GetReport("argument")["engine"]);
	EXPECT_TRUE(GetPicture("three") == GetPicture("argument"));
	EXPECT_TRUE(GetPicture("three") != GetPicture("four")) << "nothing to see of the version";
}

TEST_F(RunArguments, AnEngineThatIsNoneIsAMistake)
{
	Folder.WriteFrame("a.json", "");
	const FOutcome Outcome = Folder.Call("run a.json --engine 4.27 --out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("\"4.27\" is not one of the versions 5.1, "));
	EXPECT_FALSE(ProgramTest::Files::exists(Folder.Path / "out"));
}

TEST_F(RunArguments, PluginIsAddedToTheConfigs)
{
	const std::string Half = R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libHalfBright.so"])";
	Folder.WriteFrame("half.json", Half);
	Run("half.json", "--plugin " + SwapChannels, "out");
	Drydock::FImageFile File((Folder.Path / "out/scene_linear.exr").string());
	const std::vector<std::vector<float>> Planes =
		File.Read({File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")});
	for (size_t Pixel = 0; Pixel < 16 * 8; ++Pixel)
	{
		ASSERT_EQ(0.125f, Planes[0][Pixel]);
		ASSERT_EQ(static_cast<float>(Pixel / 16) / 16, Planes[1][Pixel]);
		ASSERT_EQ(static_cast<float>(Pixel % 16) / 32, Planes[2][Pixel]);
	}
}

TEST_F(RunArguments, PluginTakesThePlaceOfOneOfItsName)
{
	Folder.WriteFrame("none.json", R"(, "plugins": ["nowhere/libSwapChannels.so"])");
	EXPECT_EQ(3, Folder.Call("run none.json --out out").ExitCode);
	Run("none.json", "--plugin " + SwapChannels, "out");
	EXPECT_THAT(Folder.Call("run none.json --plugin gone.so --out out").Printed, HasSubstr("gone.so does not exist"));
}

TEST_F(RunArguments, FingerprintsTellWhichPassesWriteSomethingElse)
{
	Folder.WriteFrame("a.json", Bloom);
	Run("a.json", "", "without");
	EXPECT_TRUE(GetWritten("without").empty());
	Run("a.json", "--fingerprints", "one");
	Run("a.json", "--fingerprints --threads 1", "two");
	Run("a.json", "--fingerprints --pp VignetteIntensity=1", "three");
	const auto One = GetWritten("one");
	const auto Three = GetWritten("three");
	EXPECT_EQ(One, GetWritten("two"));
	// The vignette is the tonemapper's, which comes last: nothing before it changes.
	ASSERT_EQ(One.size(), Three.size());
	ASSERT_GT(One.size(), 2u);
	for (const auto& [Name, Written] : One)
	{
		const bool bTonemap = Name.find("Tonemap") != std::string::npos;
		EXPECT_EQ(!bTonemap, Written == Three.at(Name)) << Name;
		for (const auto& [Resource, Fingerprint] : Written.items())
		{
			EXPECT_THAT(Fingerprint.get<std::string>(), testing::MatchesRegex("[0-9a-f]{32}")) << Resource;
		}
	}
	// The report is otherwise the same.
	nlohmann::json Plain = GetReport("one");
	for (nlohmann::json& Pass : Plain["passes"])
	{
		Pass.erase("written");
	}
	EXPECT_EQ(GetReport("without")["passes"], Plain["passes"]);
}
