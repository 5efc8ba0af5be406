// Lists of frames as a person writes them.
#include <gtest/gtest.h>

#include "Config/FrameList.h"

using namespace Drydock;

namespace
{

std::vector<int> List(const std::string& Text)
{
	std::string Error;
	const std::optional<FFrameList> Parsed = ParseFrameList(Text, Error);
	EXPECT_TRUE(Parsed) << Error;
	return Parsed ? ListFrames(*Parsed, {2, 3, 7}) : std::vector<int>();
}

std::string ErrorOf(const std::string& Text)
{
	std::string Error;
	return ParseFrameList(Text, Error) ? "none" : Error;
}

} // namespace

TEST(FrameList, NamesFramesRangesAndSteps)
{
	EXPECT_EQ((std::vector<int>{5}), List("5"));
	EXPECT_EQ((std::vector<int>{1, 2, 3}), List("1-3"));
	EXPECT_EQ((std::vector<int>{1, 4, 7}), List("1-9x3"));
	EXPECT_EQ((std::vector<int>{0, 2, 3, 10}), List("0,2-3,10"));
}

TEST(FrameList, AllAreThoseThatExist)
{
	EXPECT_EQ((std::vector<int>{2, 3, 7}), List("all"));
}

TEST(FrameList, GreatestNumberIsAFrame)
{
	EXPECT_EQ((std::vector<int>{2147483646, 2147483647}), List("2147483646-2147483647"));
}

TEST(FrameList, WhatIsNoneSaysWhatWasExpected)
{
	const std::string Expected = " is not a frame or a range of frames: expected all, 1-8, 1-9x2 or 1,3,5-8";
	for (const std::string Part : {"", "x", "-3", "1-", "1x2", "1-3x", "1-3y", "1 ", "1.5", "99999999999"})
	{
		EXPECT_EQ("\"" + Part + "\"" + Expected, ErrorOf(Part));
	}
	EXPECT_EQ("\"\"" + Expected, ErrorOf("1,"));
}

TEST(FrameList, FramesAscend)
{
	EXPECT_EQ("\"3-1\" ends before it begins", ErrorOf("3-1"));
	EXPECT_EQ("frame 2 comes after 3: frames are rendered in ascending order, each once", ErrorOf("1-3,2"));
	EXPECT_EQ("the step of \"1-3x0\" must be 1 at least", ErrorOf("1-3x0"));
}

TEST(FrameList, ASlipOfTheFingerIsCaught)
{
	EXPECT_EQ("\"1-2000000000\" is more than 100000 frames", ErrorOf("1-2000000000"));
	EXPECT_EQ("none", ErrorOf("1-100000"));
	EXPECT_EQ("\"1-100000,100001\" is more than 100000 frames", ErrorOf("1-100000,100001"));
}
