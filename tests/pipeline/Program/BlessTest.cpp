// Baselines: diff takes what a person blessed, and nothing that was changed since; a build server cannot bless.
#include <gmock/gmock.h>

#include "../ProgramTestUtils.h"

#include <cstdlib>

using namespace ProgramTest;
using testing::HasSubstr;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

class Bless : public testing::Test
{
protected:
	Bless()
	{
		unsetenv("CI");
		Folder.WriteFrame("a.json", R"(, "outputs": {"dump": ["Tonemap*"]})");
		Folder.WriteFrame(
			"b.json", R"(, "outputs": {"dump": ["Tonemap*"]}, "camera": {"Settings": {"ColorGain": [2, 2, 2, 1]}})");
		EXPECT_EQ(0, Folder.Call("run a.json").ExitCode);
		EXPECT_EQ(0, Folder.Call("run b.json").ExitCode);
	}

	const std::string Diff = "diff out/a baselines/a --baseline --max 0";
	const FProgramFolder Folder{"bless"};
};

} // namespace

TEST_F(Bless, OnlyBlessedPicturesAreABaseline)
{
	const FOutcome Before = Folder.Call("diff out/a out/b --baseline");
	EXPECT_EQ(2, Before.ExitCode);
	EXPECT_THAT(Before.Printed, HasSubstr("nobody blessed these pictures"));
	const FOutcome Blessed = Folder.Call("bless out/a --because 'the first one'");
	ASSERT_EQ(0, Blessed.ExitCode) << Blessed.Printed;
	EXPECT_THAT(Folder.Read("baselines/a/baseline.json"), HasSubstr("the first one"));
	EXPECT_EQ(0, Folder.Call(Diff).ExitCode);
	EXPECT_EQ(1, Folder.Call("diff out/b baselines/a --baseline --max 0.001").ExitCode);
}

TEST_F(Bless, ANewPictureTakesThePlaceOfTheOldOne)
{
	EXPECT_EQ(0, Folder.Call("bless out/b --to baselines/a --because old").ExitCode);
	EXPECT_EQ(1, Folder.Call(Diff).ExitCode);
	EXPECT_EQ(0, Folder.Call("bless out/a --because 'meant to change'").ExitCode);
	EXPECT_EQ(0, Folder.Call(Diff).ExitCode);
}

TEST_F(Bless, WhatWasChangedSinceIsRefused)
{
	EXPECT_EQ(0, Folder.Call("bless out/a --because first").ExitCode);
	const std::string Final = Folder.Read("baselines/a/final.exr");
	Folder.Write("baselines/a/final.exr", Folder.Read("out/b/final.exr"));
	for (const std::string& Call : {Diff, std::string("diff out/a baselines/a")})
	{
		const FOutcome Changed = Folder.Call(Call);
		EXPECT_EQ(2, Changed.ExitCode);
		EXPECT_THAT(
			Changed.Printed, HasSubstr("baselines/a/final.exr: error DD5036: this is not the file that was blessed"));
	}
	Folder.Write("baselines/a/final.exr", Final);
	EXPECT_EQ(0, Folder.Call(Diff).ExitCode);
	Folder.Write("baselines/a/passes/099.New.New.exr", Final);
	EXPECT_THAT(Folder.Call(Diff).Printed, HasSubstr("nobody blessed this file"));
	Files::remove(Folder.Path / "baselines/a/passes/099.New.New.exr");
	Files::remove(Folder.Path / "baselines/a/final.exr");
	EXPECT_EQ(2, Folder.Call(Diff).ExitCode);
	Folder.Write("baselines/a/baseline.json", "{");
	EXPECT_THAT(Folder.Call(Diff).Printed, HasSubstr("the record of the baseline is damaged"));
}

TEST_F(Bless, NeedsAPersonAReasonAndARun)
{
	EXPECT_EQ(2, Folder.Call("bless out/a").ExitCode);
	EXPECT_EQ(2, Folder.Call("bless out/a --because ' '").ExitCode);
	EXPECT_EQ(3, Folder.Call("bless out --because x").ExitCode);
	setenv("CI", "true", 1);
	const FOutcome Server = Folder.Call("bless out/a --because x");
	unsetenv("CI");
	EXPECT_EQ(2, Server.ExitCode);
	EXPECT_THAT(Server.Printed, HasSubstr("a build server (CI is set) cannot accept a picture"));
	EXPECT_FALSE(Files::exists(Folder.Path / "baselines"));
}
