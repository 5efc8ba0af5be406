// `drydock run --report`: when the page is written, what it refuses, and what it tells of the run before.
#include <gtest/gtest.h>

#include "PageTestUtils.h"
#include "Report/PortablePaths.h"

#include <regex>

using namespace Drydock;
using namespace ProgramTest;
using namespace ReportTest;

namespace
{

bool HasReport(const FProgramFolder& Folder)
{
	return Files::exists(Folder.Path / "out/frame/report.html");
}

} // namespace

TEST(RunReport, IsWrittenUnlessSomebodyTurnsItOffAndTheCommandLineBeatsTheConfig)
{
	const FProgramFolder Folder("report_when");
	Folder.WriteFrame("frame.json", "");
	EXPECT_EQ(0, Folder.Call("run frame.json --json").ExitCode);
	EXPECT_FALSE(HasReport(Folder));
	const FOutcome Plain = Folder.Call("run frame.json");
	EXPECT_EQ(0, Plain.ExitCode);
	EXPECT_NE(std::string::npos, Plain.Printed.find("page     out/frame/report.html\n")) << Plain.Printed;
	EXPECT_TRUE(std::regex_search(Plain.Printed, std::regex("time .*, save [0-9]+, page [0-9]+\n"))) << Plain.Printed;
	EXPECT_TRUE(HasReport(Folder));
	Folder.WriteFrame("frame.json", R"(, "outputs": {"report": "full"})");
	EXPECT_EQ(0, Folder.Call("run frame.json --report off").ExitCode);
	EXPECT_FALSE(HasReport(Folder)) << "that of the run before stayed";
	EXPECT_EQ(0, Folder.Call("run frame.json").ExitCode);
	ASSERT_TRUE(HasReport(Folder));
	EXPECT_TRUE(ReadData(Folder)["pictures"][0].contains("values"));
}

TEST(RunReport, WordsThatAreNoneAreRefused)
{
	const FProgramFolder Folder("report_words");
	Folder.WriteFrame("frame.json", "");
	EXPECT_EQ(2, Folder.Call("run frame.json --report loud").ExitCode);
	Folder.WriteFrame("frame.json", R"(, "outputs": {"report": "loud"})");
	const FOutcome Outcome = Folder.Call("run frame.json");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("/outputs/report")) << Outcome.Printed;
	EXPECT_FALSE(Files::exists(Folder.Path / "out"));
}

TEST(RunReport, HasNoCodesOfAnotherDisplayThanSrgb)
{
	const FProgramFolder Folder("report_device");
	Folder.WriteFrame("frame.json", "");
	EXPECT_EQ(0, Folder.Call("run frame.json --report full --set r.HDR.Display.OutputDevice=3").ExitCode);
	const FJson Pictures = ReadData(Folder)["pictures"];
	EXPECT_FALSE(Pictures[0].contains("values"));
	EXPECT_EQ("Final picture, as an sRGB display shows it", Pictures[0]["label"]);
	EXPECT_TRUE(Pictures[1].contains("values"));
}

TEST(RunReport, ShowsTheRunBeforeBesideThisOne)
{
	const FProgramFolder Folder("report_before");
	Folder.WriteFrame("frame.json", "");
	EXPECT_EQ(0, Folder.Call("run frame.json --report").ExitCode);
	EXPECT_FALSE(ReadData(Folder).contains("previous"));
	const std::string Final = Folder.Read("out/frame/final.png");
	EXPECT_EQ(0, Folder.Call("run frame.json --report --pp BloomIntensity=3").ExitCode);
	const FJson Report = ReadData(Folder);
	EXPECT_EQ(3.0, Report["run"]["settings"]["BloomIntensity"]);
	EXPECT_EQ(0.675, Report["previous"]["run"]["settings"]["BloomIntensity"]);
	EXPECT_EQ("previous", Report["pictures"].back()["role"]);
	EXPECT_NE(Final, Folder.Read("out/frame/final.png"));
	EXPECT_EQ((Final.size() + 2) / 3 * 4, Report["pictures"].back()["png"].get<std::string>().size());
}

TEST(RunReport, HasTheStoryOfSettingsAndWhatLeavingOutSaves)
{
	const FProgramFolder Folder("report_story");
	Folder.WriteFrame(
		"frame.json", R"(, "volumes": [{"name": "V", "bUnbound": true, "Settings": {"BloomIntensity": 2}}])");
	EXPECT_EQ(0, Folder.Call("run frame.json --report").ExitCode);
	const FJson Report = ReadData(Folder);
	EXPECT_EQ("V", Report["blend"]["volumes"][0]["name"]);
	EXPECT_EQ(2.0, Report["blend"]["ledger"]["BloomIntensity"].back()["after"]);
	EXPECT_GE(Report["explain"]["withoutSkipping"]["passes"], Report["explain"]["cost"]["passes"]);
}

// LensFlareIntensity is 0 here for want of lens flares: nobody gave it.
TEST(RunReport, NamesNoSettingThatNobodyGave)
{
	const FProgramFolder Folder("report_touched");
	Folder.WriteFrame("frame.json", "");
	EXPECT_EQ(0, Folder.Call("run frame.json --pp BloomIntensity=2").ExitCode);
	const FJson Report = ReadData(Folder);
	ASSERT_EQ(1u, Report["settings"].size()) << Report["settings"];
	EXPECT_EQ("BloomIntensity", Report["settings"][0]["name"]);
}

TEST(RunReport, OfAPluginHasItsPassesItsVariablesAndTheLedger)
{
	const FProgramFolder Folder("report_plugin");
	Folder.WriteFrame("frame.json", R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libTestPlugin.so"])");
	EXPECT_EQ(0, Folder.Call("run frame.json --pp BloomIntensity=2 --set r.BloomQuality=3 --set r.TestPlugin.Enabled=1")
					 .ExitCode);
	const FJson Report = ReadData(Folder);
	ASSERT_FALSE(Report["explain"]["plugins"].empty());
	EXPECT_EQ("plugin libTestPlugin.so", Report["explain"]["plugins"][0]["name"]);
	EXPECT_EQ("r.BloomQuality", Report["run"]["variables"][0]["name"]);
	EXPECT_EQ(2.0, Report["blend"]["ledger"]["BloomIntensity"].back()["after"]);
}

TEST(PortablePaths, AreShortenedAndVirtualOnesAndPicturesStay)
{
	const std::string Here = Files::current_path().string();
	EXPECT_EQ(R"({"a": "configs/x.json", "b": ".../frame.exr:3: no"})",
		MakePathsPortable(R"({"a": ")" + Here + R"(/configs/x.json", "b": "/usr/lib/frame.exr:3: no"})"));
	for (const char* const Kept : {"/Engine/Private/Bloom.usf", "a/usr/lib", "iVBOR+/usr/bin/x", "https://tmp/usr/x",
			 "../usr/lib/x", "/volumes/0", "/usr"})
	{
		EXPECT_EQ(Kept, MakePathsPortable(Kept));
	}
	EXPECT_EQ("configs/x.json", MakePathsPortable(DRYDOCK_TEST_SOURCE_DIR "/configs/x.json"));
}

TEST(RunReport, OfToonBloomIsUnderFiveMegabytesBesideTheRunBefore)
{
	const FProgramFolder Folder("report_size");
	for (int Run = 0; Run < 2; ++Run)
	{
		EXPECT_EQ(0,
			Folder.Call("run '" DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom.json' --report --out out/frame").ExitCode);
	}
	EXPECT_TRUE(ReadData(Folder).contains("previous"));
	EXPECT_LT(Files::file_size(Folder.Path / "out/frame/report.html"), 5000000u);
}

TEST(StudyReport, IsAPageOfItsOwnOfTheFormThatItsSchemaStates)
{
	const FProgramFolder Folder("report_study");
	Folder.WriteFrame(
		"frame.json", R"(, "study": {"axes": [{"name": "r.BloomQuality", "values": [1, 5]}], "repetitions": 1},
										"volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1}}])");
	EXPECT_EQ(0, Folder.Call("study frame.json --report off").ExitCode);
	EXPECT_FALSE(Files::exists(Folder.Path / "out/frame/study.html"));
	EXPECT_EQ(0, Folder.Call("run frame.json --report").ExitCode);
	EXPECT_EQ(0, Folder.Call("study frame.json --report").ExitCode);
	EXPECT_TRUE(HasReport(Folder)) << "the run's page is not the study's to replace";
	const FJson Report = ReadData(Folder, "out/frame/study.html");
	const FJson Schema = ReadSchemaFile("study.schema.json");
	EXPECT_EQ(std::vector<std::string>(), FSchemaCheck(Schema).Check(Report));
	EXPECT_EQ(FJson::parse(Folder.Read("out/frame/study.json")), Report["study"]);
	EXPECT_FALSE(Report["insets"][0]["pictures"].empty());
}

TEST(RunReport, APageThatSomebodyElsePutThereIsNotReplaced)
{
	const FProgramFolder Folder("report_foreign");
	Folder.WriteFrame("frame.json", "");
	Folder.Write("out/frame/report.html", "mine");
	const FOutcome Outcome = Folder.Call("run frame.json --report");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("DD1080")) << Outcome.Printed;
	EXPECT_EQ("mine", Folder.Read("out/frame/report.html"));
}
