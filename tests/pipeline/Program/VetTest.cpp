// `drydock vet`: one table and one exit code for all that is found in a plugin.
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include "../JUnitCheck.h"
#include "../ProgramTestUtils.h"

using namespace ProgramTest;
using testing::HasSubstr;

namespace
{

std::vector<std::string> GetSteps(const nlohmann::json& Json)
{
	std::vector<std::string> Steps;
	for (const auto& Step : Json["steps"])
	{
		Steps.push_back(Step["step"].get<std::string>() + " " + std::to_string(Step["exitCode"].get<int>()));
	}
	return Steps;
}

} // namespace

TEST(Vet, AGoodPluginPassesEveryStepAndABrokenLineIsFound)
{
	const FProgramFolder Folder("vet");
	ASSERT_EQ(0, Folder.Call("new MyPatch").ExitCode);
	const FOutcome Good = Folder.Call("vet MyPatch --out v --junit v.xml --json");
	EXPECT_EQ(0, Good.ExitCode) << Good.Printed;
	EXPECT_THAT(GetSteps(nlohmann::json::parse(Good.Printed)),
		testing::ElementsAre("build 0", "check 0", "lint 0", "run 0", "prove 0", "hazards 0"));
	EXPECT_EQ(6u, JUnitTest::ReadSuites(Folder.Read("v.xml")).at(0).Children.size());
	EXPECT_TRUE(Files::exists(Folder.Path / "v/run/final.png"));

	const std::string Shader = "MyPatch/Shaders/Private/MyPatch.usf";
	const std::string Text = Folder.Read(Shader);
	Folder.Write(Shader, Text + "\nfloat Broken( { }\n");
	const FOutcome Broken = Folder.Call("vet MyPatch --out v");
	EXPECT_EQ(2, Broken.ExitCode) << Broken.Printed;
	EXPECT_THAT(Broken.Printed, HasSubstr("check"));
	EXPECT_THAT(Broken.Printed, testing::Not(HasSubstr("prove")));
	EXPECT_THAT(Folder.Read("v/check.sarif"), HasSubstr("MyPatch.usf"));
}

TEST(Vet, AFolderWithoutAPluginIsAMistake)
{
	const FProgramFolder Folder("vet_none");
	EXPECT_EQ(2, Folder.Call("vet none").ExitCode);
}
