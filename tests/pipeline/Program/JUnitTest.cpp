// What verbs write with --junit is JUnit XML by the rules of its schemas, and tells what passed, failed and could not
// be asked.
#include "../JUnitCheck.h"
#include "../ProgramTestUtils.h"

#include "Matrix/MatrixTable.h"
#include "Program/CommandLine.h"
#include "Program/ProgramModel.h"
#include "Text/JUnit.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

using namespace JUnitTest;
using namespace ProgramTest;
using namespace Drydock;
using testing::HasSubstr;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

class JUnit : public testing::Test
{
protected:
	/** The suite that the verb writes; there is one. */
	FElement GetSuite(const std::string& Arguments, int ExitCode) const
	{
		const FOutcome Outcome = Folder.Call(Arguments + " --junit results/junit.xml");
		EXPECT_EQ(ExitCode, Outcome.ExitCode) << Outcome.Printed;
		const std::string Path = (Folder.Path / "results/junit.xml").string();
		if (std::system("command -v xmllint > /dev/null 2>&1") == 0)
		{
			EXPECT_EQ(0, std::system(("xmllint --noout '" + Path + "'").c_str()));
		}
		std::vector<FElement> Suites = ReadSuites(Folder.Read("results/junit.xml"));
		EXPECT_EQ(1u, Suites.size());
		return Suites.empty() ? FElement() : Suites[0];
	}

	const FProgramFolder Folder{"junit"};
};

} // namespace

TEST(JUnitText, EscapesWhatXmlCannotHold)
{
	const std::string Strange = "a<b>&\"c\"\nsecond\x01 \xC3\xA4 \xFF \xED\xA0\x80";
	const std::string Text =
		MakeJUnit({{Strange, {{.Name = Strange, .Outcome = EJUnitOutcome::Failed, .Message = Strange}}}});
	const FElement Suite = ReadSuites(Text).at(0);
	EXPECT_EQ("a<b>&\"c\"\nsecond? \xC3\xA4 ? ???", Suite.Attributes.at("name"));
	EXPECT_EQ("a<b>&\"c\"", Suite.Children.at(0).Children.at(0).Attributes.at("message"));
	EXPECT_EQ("a<b>&\"c\"\nsecond? \xC3\xA4 ? ???", Suite.Children.at(0).Children.at(0).Text);
}

TEST(JUnitText, CountsEveryOutcome)
{
	const FElement Suite = ReadSuites(
		MakeJUnit({{"suite",
			{{.Name = "a", .Seconds = 1.5}, {.Name = "b", .Outcome = EJUnitOutcome::Failed, .Message = "m"},
				{.Name = "c", .Outcome = EJUnitOutcome::Broken, .Message = "m"},
				{.Name = "d", .Outcome = EJUnitOutcome::Skipped, .Message = "m"}, {.Name = "e", .Output = "said"}}}}))
							   .at(0);
	EXPECT_EQ("5", Suite.Attributes.at("tests"));
	EXPECT_EQ("1.500", Suite.Attributes.at("time"));
	EXPECT_EQ("failure", GetOutcome(*FindCase(Suite, "b")));
	EXPECT_EQ("error", GetOutcome(*FindCase(Suite, "c")));
	EXPECT_EQ("skipped", GetOutcome(*FindCase(Suite, "d")));
	EXPECT_EQ("said", FindCase(Suite, "e")->Children.at(0).Text);
	EXPECT_TRUE(ReadSuites(MakeJUnit({})).empty());
}

TEST(JUnitText, TheRulesAreNotEmpty)
{
	EXPECT_THROW(FXmlReader("<a>").ReadDocument(), std::runtime_error);
	EXPECT_THROW(FXmlReader("<?xml version=\"1.0\" encoding=\"UTF-8\"?><a b=\"1\" b=\"2\"/>").ReadDocument(),
		std::runtime_error);
}

TEST_F(JUnit, TheVerbsThatFindSomethingHaveAllThreeOptions)
{
	std::vector<std::string> Verbs;
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		for (const FOptionModel& Option : Verb.Options)
		{
			if (Option.GetName() == "--junit" || Option.GetName() == "--sarif" || Option.GetName() == "--fail-on")
			{
				Verbs.push_back(Verb.Name);
			}
		}
	}
	std::vector<std::string> Expected;
	for (const char* Verb : {"run", "check", "prove", "hazards", "lint", "study", "diff", "matrix", "vet"})
	{
		Expected.insert(Expected.end(), 3, Verb);
	}
	EXPECT_THAT(Verbs, testing::UnorderedElementsAreArray(Expected));
}

TEST_F(JUnit, CheckHasACaseForEachFamilyOfMessages)
{
	Folder.WriteFrame("good.json", "");
	const FElement Good = GetSuite("check good.json", 0);
	EXPECT_EQ("good.json", Good.Attributes.at("name"));
	EXPECT_EQ(6u, Good.Children.size());
	EXPECT_EQ("0", Good.Attributes.at("failures"));
	Folder.WriteFrame("bad.json", R"(, "camra": {}, "camera": {"Settings": {"BloomIntensty": 1}})");
	const FElement Bad = GetSuite("check bad.json", 2);
	const FElement* const Config = FindCase(Bad, "config");
	ASSERT_EQ("failure", GetOutcome(*Config));
	EXPECT_THAT(Config->Children.at(0).Text, HasSubstr("did you mean camera?"));
	EXPECT_EQ("", GetOutcome(*FindCase(Bad, "shaders")));
}

TEST_F(JUnit, DiffHasACaseForEachPicture)
{
	Folder.WriteFrame("a.json", "");
	Folder.WriteFrame("b.json", R"(, "camera": {"Settings": {"ColorGain": [2, 2, 2, 1]}})");
	Folder.Call("run a.json");
	Folder.Call("run b.json");
	const FElement Same = GetSuite("diff out/a out/a --max 0", 0);
	EXPECT_EQ("out/a against out/a", Same.Attributes.at("name"));
	EXPECT_EQ("", GetOutcome(*FindCase(Same, "final")));
	const FElement Other = GetSuite("diff out/a out/b --max 0.001", 1);
	ASSERT_EQ("failure", GetOutcome(*FindCase(Other, "final")));
	EXPECT_THAT(FindCase(Other, "final")->Children.at(0).Text, HasSubstr("more than the allowed 0.001"));
	EXPECT_EQ("0", GetSuite("diff out/a out/b", 0).Attributes.at("failures")); // nothing is demanded
}

TEST_F(JUnit, WhatCannotBeAskedIsAnError)
{
	const FElement Suite = GetSuite("diff no_such.png neither.png", 3);
	ASSERT_EQ("error", GetOutcome(*FindCase(Suite, "runs")));
	EXPECT_THAT(FindCase(Suite, "runs")->Children.at(0).Text, HasSubstr("no_such.png"));
	EXPECT_EQ("error", GetOutcome(*FindCase(GetSuite("study no_such.json", 3), "runs")));
	EXPECT_EQ("error", GetOutcome(*FindCase(GetSuite("matrix no_such_folder", 2), "runs")));
}

TEST_F(JUnit, StudyHasACaseForEachVariantAndTheChoice)
{
	const std::string Axes = R"("axes": [{"name": "r.BloomQuality", "values": [0, 5]}], "repetitions": 1})";
	const std::string Bloom = R"(, "camera": {"Settings": {"BloomIntensity": 1, "BloomThreshold": -1}}, )";
	Folder.WriteFrame("study.json", Bloom + R"("budget": {"max": 1000}, "study": {)" + Axes);
	const FElement Suite = GetSuite("study study.json", 0);
	EXPECT_EQ(3u, Suite.Children.size());
	EXPECT_EQ("0", Suite.Attributes.at("failures"));
	EXPECT_EQ("", GetOutcome(*FindCase(Suite, "recommended")));
	Folder.WriteFrame("strict.json", Bloom + R"("budget": {"max": 1e-30, "ms": 1e-9}, "study": {)" + Axes);
	const FElement Strict = GetSuite("study strict.json", 0);
	ASSERT_EQ("failure", GetOutcome(*FindCase(Strict, "recommended")));
	EXPECT_THAT(FindCase(Strict, "recommended")->Children.at(0).Text, HasSubstr("no variant meets the budget"));
	Folder.WriteFrame("free.json", Bloom + R"("study": {)" + Axes);
	const FElement Free = GetSuite("study free.json", 0);
	EXPECT_EQ(2u, Free.Children.size()); // nobody gave a budget
	EXPECT_EQ("0", Free.Attributes.at("failures"));
}

TEST_F(JUnit, AFileThatCannotBeWrittenIsSaid)
{
	Folder.WriteFrame("good.json", "");
	Folder.Write("results", "a file where the folder should be");
	const FOutcome Outcome = Folder.Call("check good.json --junit results/junit.xml");
	EXPECT_EQ(3, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_EQ("a file where the folder should be", Folder.Read("results"));
}

TEST(JUnitMatrix, HasThreeCasesForEachVersion)
{
	FVersionMatrix Matrix;
	Matrix.Name = "MyTint";
	FMatrixRow Unbuilt;
	Unbuilt.Minor = 1;
	Unbuilt.Build.FirstError = FMatrixMessage{.File = "MyTint.cpp", .Line = 41, .Text = "'X' was not declared"};
	FMatrixRow Crashed;
	Crashed.Minor = 3;
	Crashed.Build.bBuilt = true;
	Crashed.Run.emplace();
	Crashed.Run->ExitCode = 71;
	Crashed.Run->FirstError =
		FMatrixMessage{.Code = 2086, .Where = "plugin libMyTint.so", .Text = "the plugin crashed"};
	FMatrixRow Good;
	Good.Minor = 4;
	Good.Build.bBuilt = true;
	Good.Run.emplace();
	Good.Picture.emplace();
	Good.Picture->Fingerprint = "0123456789abcdef";
	Matrix.Rows = {Unbuilt, Crashed, Good};
	const FElement Suite = ReadSuites(MakeJUnit({{"MyTint", MakeMatrixCases(Matrix)}})).at(0);
	ASSERT_EQ(9u, Suite.Children.size());
	EXPECT_EQ(
		"MyTint.cpp:41: 'X' was not declared", FindCase(Suite, "5.1 builds")->Children.at(0).Attributes.at("message"));
	EXPECT_EQ("skipped", GetOutcome(*FindCase(Suite, "5.1 runs")));
	EXPECT_EQ("", GetOutcome(*FindCase(Suite, "5.3 builds")));
	EXPECT_EQ("failure", GetOutcome(*FindCase(Suite, "5.3 runs")));
	EXPECT_THAT(FindCase(Suite, "5.3 runs")->Children.at(0).Text, HasSubstr("the plugin crashed"));
	EXPECT_EQ("skipped", GetOutcome(*FindCase(Suite, "5.3 picture")));
	EXPECT_EQ("", GetOutcome(*FindCase(Suite, "5.4 runs")));
	EXPECT_EQ("01234567", FindCase(Suite, "5.4 picture")->Children.at(0).Text);
}

TEST_F(JUnit, ProveHazardsAndLintHaveCases)
{
	Folder.WriteFrame("a.json", "");
	const FElement Proven = GetSuite("prove a.json --only OneThread", 0);
	ASSERT_EQ(1u, Proven.Children.size());
	EXPECT_EQ("OneThread", Proven.Children[0].Attributes.at("name"));
	const FElement Hazards = GetSuite("hazards a.json --pass Tonemap", 0);
	EXPECT_LT(10u, Hazards.Children.size());
	Folder.Write("a.usf", R"(RWTexture2D<float4> Out;
[numthreads(8, 8, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID) { Out[Id.xy] = Out[Id.xy] + 1; }
)");
	const FElement Lint = GetSuite("lint a.usf", 1);
	EXPECT_EQ("1", Lint.Attributes.at("failures"));
}

TEST_F(JUnit, SarifNamesRuleLevelAndPlace)
{
	Folder.WriteFrame("bad.json", R"(,
 "camra": {})");
	EXPECT_EQ(2, Folder.Call("check bad.json --sarif out/a.sarif").ExitCode);
	const auto Document = nlohmann::json::parse(Folder.Read("out/a.sarif"));
	EXPECT_EQ("2.1.0", Document["version"]);
	const auto& Run = Document["runs"][0];
	EXPECT_EQ("drydock check", Run["tool"]["driver"]["name"]);
	EXPECT_EQ("DD1005", Run["tool"]["driver"]["rules"][0]["id"]);
	const auto& Result = Run["results"][0];
	EXPECT_EQ("DD1005", Result["ruleId"]);
	EXPECT_EQ("error", Result["level"]);
	EXPECT_THAT(Result["message"]["text"].get<std::string>(), HasSubstr("did you mean camera?"));
	const auto& Place = Result["locations"][0]["physicalLocation"];
	EXPECT_EQ("bad.json", Place["artifactLocation"]["uri"]);
	EXPECT_EQ(2, Place["region"]["startLine"]);
	EXPECT_EQ(2, Place["region"]["startColumn"]);
	EXPECT_EQ("/camra", Result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]);
}

TEST_F(JUnit, SarifHoldsFindingsThatAreNotMessages)
{
	Folder.WriteFrame("a.json", "");
	Folder.WriteFrame("b.json", R"(, "camera": {"Settings": {"ColorGain": [2, 2, 2, 1]}})");
	Folder.Call("run a.json");
	Folder.Call("run b.json");
	EXPECT_EQ(1, Folder.Call("diff out/a out/b --max 0.001 --sarif out/d.sarif").ExitCode);
	const auto Document = nlohmann::json::parse(Folder.Read("out/d.sarif"));
	EXPECT_EQ("difference", Document["runs"][0]["results"][0]["ruleId"]);
	EXPECT_EQ(0, Folder.Call("diff out/a out/a --max 0 --sarif out/s.sarif").ExitCode);
	EXPECT_TRUE(nlohmann::json::parse(Folder.Read("out/s.sarif"))["runs"][0]["results"].empty());
}

TEST_F(JUnit, AWarningFailsWhereItIsAskedTo)
{
	Folder.WriteFrame("w.json", R"(, "camera": {"Settings": {"BloomIntensity": -1}})");
	for (const std::string Verb : {"check", "run"})
	{
		EXPECT_EQ(0, Folder.Call(Verb + " w.json").ExitCode) << Verb;
		EXPECT_EQ(0, Folder.Call(Verb + " w.json --fail-on error").ExitCode) << Verb;
		const FElement Suite = GetSuite(Verb + " w.json --fail-on warning", 1);
		ASSERT_EQ("failure", GetOutcome(*FindCase(Suite, "no warnings")));
		EXPECT_THAT(FindCase(Suite, "no warnings")->Children.at(0).Text, HasSubstr("BloomIntensity"));
	}
	EXPECT_EQ(2, Folder.Call("check w.json --fail-on warnings").ExitCode);
}
