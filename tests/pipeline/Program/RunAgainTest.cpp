// A run records what it depends on, is repeated from its record, and is compared by it.
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include "ProgramTestUtils.h"
#include "Run/RunDifference.h"

using namespace Drydock;
using namespace ProgramTest;
using testing::HasSubstr;
using testing::Not;

namespace
{

using FJson = nlohmann::json;

FJson ReadRecord(const FProgramFolder& Folder, const std::string& File)
{
	return FJson::parse(Folder.Read(File));
}

} // namespace

TEST(RunRecord, HoldsWhatTheRunDependsOn)
{
	const FProgramFolder Folder("record");
	Folder.WriteFrame("frame.json", R"(, "cvars": {"r.Tonemapper.Sharpen": 1})");
	ASSERT_EQ(0, Folder.Call("run frame.json --set r.BloomQuality=3 --precision double --threads 1").ExitCode);
	const FJson Run = ReadRecord(Folder, "out/frame/run.json");
	EXPECT_EQ(FJson({"--set", "r.BloomQuality=3", "--precision", "double"}), Run["arguments"]);
	std::map<std::string, std::pair<std::string, std::string>> Variables;
	for (const FJson& Variable : Run["variables"])
	{
		Variables[Variable["name"]] = {Variable["value"], Variable["setBy"]};
	}
	EXPECT_EQ((std::pair<std::string, std::string>{"3", "command line"}), Variables["r.BloomQuality"]);
	EXPECT_EQ("config", Variables["r.Tonemapper.Sharpen"].second);
	EXPECT_EQ(0u, Variables.count("r.Drydock.Threads"));
	EXPECT_TRUE(Run["inputs"].contains("config"));
	EXPECT_TRUE(Run["inputs"].contains("shaders"));
	EXPECT_TRUE(Run["inputs"].contains("file " + Run["scene"]["file"].get<std::string>())) << Run["inputs"];
	EXPECT_TRUE(Run.contains("commit"));
	EXPECT_EQ("frame.json", Run["config"]);
}

TEST(RunRecord, IsTheSameBytesFromAnotherFolder)
{
	const FProgramFolder Folder("record_bytes");
	Folder.WriteFrame("frame.json", "");
	ASSERT_EQ(0, Folder.Call("run frame.json --out a").ExitCode);
	ASSERT_EQ(0, Folder.Call("run '" + (Folder.Path / "frame.json").string() + "' --out deep/b --threads 1").ExitCode);
	EXPECT_EQ(Folder.Read("a/run.json"), Folder.Read("deep/b/run.json"));
	EXPECT_THAT(Folder.Read("a/run.json"), Not(HasSubstr(Folder.Path.string())));
}

TEST(RunAgain, HasTheSameBits)
{
	const FProgramFolder Folder("again");
	Folder.WriteFrame("frame.json", "");
	ASSERT_EQ(0, Folder
					 .Call("run frame.json --exec \"r.BloomQuality 2\" --set r.LUT.Size=16 --pp BloomIntensity=3 "
						   "--storage float32 --dump *Tonemap* --out a/b")
					 .ExitCode);
	const FOutcome Again = Folder.Call("run --again a/b/run.json --out c --report off");
	ASSERT_EQ(0, Again.ExitCode) << Again.Printed;
	EXPECT_THAT(Again.Printed, Not(HasSubstr("warning")));
	for (const std::string File : {"final.exr", "final.png", "run.json"})
	{
		EXPECT_EQ(Folder.Read("a/b/" + File), Folder.Read("c/" + File)) << File;
	}
	EXPECT_EQ(ReadRecord(Folder, "c/timing.json")["config"], "../frame.json");
}

TEST(RunAgain, SaysWhatHasChangedAndTakesNothingBesides)
{
	const FProgramFolder Folder("again_changed");
	Folder.WriteFrame("frame.json", "");
	ASSERT_EQ(0, Folder.Call("run frame.json --out a").ExitCode);
	EXPECT_EQ(2, Folder.Call("run --again a/run.json --set r.BloomQuality=1").ExitCode);
	EXPECT_EQ(2, Folder.Call("run").ExitCode);
	EXPECT_EQ(3, Folder.Call("run --again b/run.json").ExitCode);
	Folder.WriteFrame("frame.json", R"(, "cvars": {"r.BloomQuality": 3})");
	const FOutcome Changed = Folder.Call("run --again a/run.json --out c --report off");
	EXPECT_EQ(0, Changed.ExitCode);
	EXPECT_THAT(Changed.Printed, HasSubstr("warning DD1026"));
	EXPECT_THAT(Changed.Printed, HasSubstr("the config has changed"));
	Files::remove(Folder.Path / "a/timing.json");
	EXPECT_THAT(Folder.Call("run --again a/run.json").Printed, HasSubstr("name the config too"));
	EXPECT_EQ(0, Folder.Call("run frame.json --again a/run.json --out d --report off").ExitCode);
}

TEST(RunDiff, NamesWhatDiffers)
{
	const FProgramFolder Folder("diff_names");
	Folder.WriteFrame("frame.json", "");
	for (const std::string Value : {"1", "3"})
	{
		ASSERT_EQ(
			0, Folder.Call("run frame.json --report off --out q" + Value + " --set r.BloomQuality=" + Value).ExitCode);
	}
	EXPECT_THAT(Folder.Call("diff q1 q3").Printed,
		testing::ContainsRegex("variable +r.BloomQuality +1 \\(command line\\) +3 "));
	const FJson Json = FJson::parse(Folder.Call("diff q1 q3 --json").Printed);
	const FJson Expected = {
		{"kind", "variable"}, {"name", "r.BloomQuality"}, {"a", "1 (command line)"}, {"b", "3 (command line)"}};
	EXPECT_EQ(Expected, Json["differences"][0]);
	EXPECT_THAT(Folder.Call("diff q1 q1").Printed, HasSubstr("both runs were made alike"));
	EXPECT_THAT(Folder.Call("diff q1 q1").Printed, Not(HasSubstr("faster")));
}

TEST(RunDiff, MeasuresBothInTurn)
{
	const FProgramFolder Folder("diff_repeat");
	Folder.WriteFrame("frame.json", "");
	ASSERT_EQ(0, Folder.Call("run frame.json --report off --out a").ExitCode);
	const FJson Times = FJson::parse(Folder.Call("diff a a --repeat 5 --json").Printed)["times"];
	EXPECT_EQ(5, Times["repeats"]);
	EXPECT_LE(Times["a"][0], Times["a"][1]);
	EXPECT_LE(Times["a"][1], Times["a"][2]);
	EXPECT_THAT(Times["sentence"].get<std::string>(), HasSubstr("of 5 runs in turn"));
	EXPECT_EQ(2, Folder.Call("diff a/final.png a/final.png --repeat 5").ExitCode);
}

TEST(DescribeTimes, NamesADifferenceOnlyWhereQuartilesPart)
{
	const FTimeSpread A = MakeTimeSpread({4.0, 2.0, 3.0, 1.0, 5.0});
	EXPECT_EQ(2.0, A.Low);
	EXPECT_EQ(3.0, A.Median);
	EXPECT_EQ(4.0, A.High);
	EXPECT_THAT(DescribeTimes(A, {1.0, 1.5, 1.9}, 5), testing::StartsWith("B is 50 % faster"));
	EXPECT_THAT(DescribeTimes(A, {4.1, 6.0, 7.0}, 5), testing::StartsWith("B is 100 % slower"));
	EXPECT_THAT(DescribeTimes(A, {1.0, 1.5, 2.0}, 5), testing::StartsWith("no measurable difference"));
	EXPECT_THAT(DescribeTimes({}, {}, 0), testing::StartsWith("not measured"));
}
