// What is read out of logs of builds, written by hand as ninja, make, g++ and ld write them.
#include <gtest/gtest.h>

#include "Patch/BuildLog.h"

using namespace Drydock;

namespace
{

const std::string GFolder = "/p/Tint";

const std::string GLog = R"(-- Configuring done
[1/4] Building CXX object CMakeFiles/Tint.dir/a.cpp.o
In file included from /p/Tint/Source/Tint/Private/a.cpp:3:
/p/Tint/Source/Tint/Public/Tint.h:12:7: warning: 'Old' is deprecated [-Wdeprecated-declarations]
   12 |   Old();
[2/4] Building CXX object CMakeFiles/Tint.dir/b.cpp.o
/p/Tint/Source/Tint/Public/Tint.h:12:7: warning: 'Old' is deprecated [-Wdeprecated-declarations]
/p/Tint/Source/Tint/Private/b.cpp:41:9: error: 'FScreenPassTextureSlice' was not declared in this scope
/usr/include/x.h:5: fatal error: y.h: No such file or directory
[3/4] Linking CXX shared library libTint.so
)";

} // namespace

TEST(BuildLog, ErrorsAreRelativeToThePlugin)
{
	const std::vector<FCompilerMessage> Errors = ReadCompilerMessages(GLog, ECompilerMessage::Error, GFolder);
	ASSERT_EQ(2u, Errors.size());
	EXPECT_EQ("Source/Tint/Private/b.cpp", Errors[0].File);
	EXPECT_EQ(41, Errors[0].Line);
	EXPECT_EQ("'FScreenPassTextureSlice' was not declared in this scope", Errors[0].Text);
	EXPECT_EQ("/usr/include/x.h", Errors[1].File);
	EXPECT_EQ(5, Errors[1].Line);
	EXPECT_EQ("y.h: No such file or directory", Errors[1].Text);
}

TEST(BuildLog, AWarningOfAHeaderCountsOnce)
{
	const std::vector<FCompilerMessage> Warnings = ReadCompilerMessages(GLog, ECompilerMessage::Warning, GFolder);
	ASSERT_EQ(1u, Warnings.size());
	EXPECT_EQ("Source/Tint/Public/Tint.h", Warnings[0].File);
	EXPECT_EQ(12, Warnings[0].Line);
}

TEST(BuildLog, TheLinkersErrorsCount)
{
	const std::vector<FCompilerMessage> Errors = ReadCompilerMessages(
		"/usr/bin/ld: a.o: in function `F()':\n"
		"/p/Tint/a.cpp:7: undefined reference to `Missing()'\n"
		"/usr/bin/ld: b.o:(.text+0x0): multiple definition of `F()'; a.o:(.text+0x0): first defined here\n"
		"collect2: error: ld returned 1 exit status\n",
		ECompilerMessage::Error, GFolder);
	ASSERT_EQ(2u, Errors.size());
	EXPECT_EQ("a.cpp", Errors[0].File);
	EXPECT_EQ(7, Errors[0].Line);
	EXPECT_EQ("undefined reference to `Missing()'", Errors[0].Text);
	EXPECT_EQ("", Errors[1].File);
	EXPECT_EQ(0, Errors[1].Line);
	EXPECT_EQ(0u, Errors[1].Text.find("multiple definition of `F()'"));
}

TEST(BuildLog, StepsAreThoseOfNinjaAndMake)
{
	const std::vector<FBuildStep> Steps = ReadBuildSteps(GLog);
	ASSERT_EQ(3u, Steps.size());
	EXPECT_EQ("Building CXX object CMakeFiles/Tint.dir/a.cpp.o", Steps[0].Name);
	EXPECT_NE(std::string::npos, Steps[0].Output.find("   12 |   Old();\n"));
	EXPECT_EQ("Linking CXX shared library libTint.so", Steps[2].Name);
	EXPECT_EQ("", Steps[2].Output);

	const std::vector<FBuildStep> OfMake =
		ReadBuildSteps("[ 50%] Building CXX object a.o\nsaid\n[100%] Built target Tint\n");
	EXPECT_EQ((std::vector<FBuildStep>{{"Building CXX object a.o", "said\n"}, {"Built target Tint", ""}}), OfMake);
}

TEST(BuildLog, WrittenStepsAreReadBack)
{
	EXPECT_EQ(ReadBuildSteps(GLog), ReadBuildSteps(WriteBuildSteps(ReadBuildSteps(GLog))));
	EXPECT_EQ("", WriteBuildSteps({}));
}

TEST(BuildLog, WhatWasUpToDateKeepsWhatItSaid)
{
	const std::vector<FBuildStep> Before = {{"Building a.o", "warning of a\n"}, {"Building b.o", "warning of b\n"}};
	EXPECT_EQ(Before, MergeBuildSteps(Before, {}));
	EXPECT_EQ((std::vector<FBuildStep>{{"Building b.o", "warning of b\n"}, {"Building a.o", ""}}),
		MergeBuildSteps(Before, {{"Building a.o", ""}}));
}

TEST(BuildLog, LongLinesAreCut)
{
	const std::string Long(1000000, 'x');
	const std::string Log = "[1/2] " + Long + "\n/p/Tint/a.cpp:7:1: error: " + Long + "\n" + Long + "\n";
	EXPECT_EQ(1u, ReadBuildSteps(Log).size());
	const std::vector<FCompilerMessage> Errors = ReadCompilerMessages(Log, ECompilerMessage::Error, GFolder);
	ASSERT_EQ(1u, Errors.size());
	EXPECT_EQ("a.cpp", Errors[0].File);
	EXPECT_EQ(7, Errors[0].Line);
	EXPECT_EQ("xxx", Errors[0].Text.substr(0, 3));
}

TEST(BuildLog, ANumberThatIsNoLineIsZero)
{
	const std::vector<FCompilerMessage> Errors =
		ReadCompilerMessages("a.cpp:99999999999:1: error: far\n", ECompilerMessage::Error, GFolder);
	ASSERT_EQ(1u, Errors.size());
	EXPECT_EQ(0, Errors[0].Line);
}
