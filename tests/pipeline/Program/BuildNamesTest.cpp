// A plugin that nobody named an engine version for: the build notes names that its version does not have, and a run
// warns.
#include <gmock/gmock.h>

#include "../ProgramTestUtils.h"

using namespace ProgramTest;
using testing::HasSubstr;
using testing::Not;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

} // namespace

TEST(BuildNames, WithoutANamedVersionBuildAndRunTellNamesOfOthers)
{
	const FProgramFolder Folder("build_names");
	ASSERT_EQ(0, Folder.Call("new MyPatch").ExitCode);
	const std::string File = "MyPatch/Source/MyPatch/Private/Later.cpp";
	Folder.Write(File, "#include \"Misc/CoreDelegates.h\"\n"
					   "void UseLater() { FCoreDelegates::GetOnPostEngineInit().Clear(); }\n");
	Folder.WriteFrame("frame.json", R"(, "plugins": ["build/MyPatch/cmake/libMyPatch.so"])");
	const char* const Sentence = "Later.cpp:2: engine 5.4 does not have FCoreDelegates::GetOnPostEngineInit";
	for (int Round = 0; Round < 2; ++Round) // nothing is compiled in the second one
	{
		const FOutcome Built = Folder.Call("build MyPatch");
		ASSERT_EQ(0, Built.ExitCode) << Built.Printed;
		const FOutcome Run = Folder.Call("run frame.json --report off");
		EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
		EXPECT_THAT(Run.Printed, HasSubstr("DD2078"));
		EXPECT_THAT(Run.Printed, HasSubstr(Sentence));
	}
	ASSERT_EQ(0, Folder.Call("build MyPatch --engine-minor 8").ExitCode);
	EXPECT_THAT(Folder.Call("run frame.json --report off").Printed, Not(HasSubstr("DD2078")));
}
