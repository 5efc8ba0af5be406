// The include graph is read as the compiler would, and its circles are found: on made-up sources.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "IncludeGraph.h"

using namespace Drydock::Test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace
{

using FCircles = std::set<std::set<std::string>>;

FCircles FindCirclesOf(const FSourceTexts& Sources)
{
	return FindCircles(MakeUnitGraph(FindIncludes(Sources)));
}

/** What the only include of From can mean. */
std::vector<std::string> ResolveIn(FSourceTexts Sources, const std::string& From, const std::string& Name)
{
	Sources[From] = "#include \"" + Name + "\"\n";
	return FindIncludes(Sources).at(0).To;
}

} // namespace

TEST(IncludeGraph, AnIncludeBesideTheFileWins)
{
	EXPECT_THAT(ResolveIn({{"a/X.h", ""}, {"b/X.h", ""}}, "b/Y.cpp", "X.h"), ElementsAre("b/X.h"));
}

TEST(IncludeGraph, OtherwiseTheNameEndsThePath)
{
	EXPECT_THAT(ResolveIn({{"a/Room/X.h", ""}, {"a/Other/X.h", ""}}, "b/Y.cpp", "Room/X.h"), ElementsAre("a/Room/X.h"));
}

TEST(IncludeGraph, AForwardingHeaderThatLiesDeeperIsNotMeant)
{
	EXPECT_THAT(ResolveIn({{"a/X.h", ""}, {"a/Runtime/Public/X.h", ""}}, "b/Y.cpp", "X.h"), ElementsAre("a/X.h"));
}

TEST(IncludeGraph, WhatNobodyHasIsFoundNowhere)
{
	EXPECT_THAT(ResolveIn({{"a/X.h", ""}}, "b/Y.cpp", "Z.h"), IsEmpty());
}

TEST(IncludeGraph, IncludesInCommentsAndInAngleBracketsDoNotCount)
{
	EXPECT_THAT(FindIncludes({{"a/X.h", "// #include \"Y.h\"\n#include <Y.h>\n"}, {"a/Y.h", ""}}), IsEmpty());
}

TEST(IncludeGraph, ARowHasNoCircle)
{
	EXPECT_EQ(FCircles(), FindCirclesOf({{"X.h", "#include \"Y.h\""}, {"Y.h", "  #  include \"Z.h\""}, {"Z.h", ""}}));
}

TEST(IncludeGraph, ADiamondHasNoCircle)
{
	EXPECT_EQ(FCircles(), FindCirclesOf({{"A.h", "#include \"B.h\"\n#include \"C.h\""}, {"B.h", "#include \"D.h\""},
							  {"C.h", "#include \"D.h\""}, {"D.h", ""}}));
}

TEST(IncludeGraph, ASourceAndItsHeaderAreOneUnit)
{
	EXPECT_EQ(FCircles(), FindCirclesOf({{"X.cpp", "#include \"X.h\""}, {"X.h", ""}}));
}

TEST(IncludeGraph, ACircleThatOnlySourcesCloseIsFound)
{
	EXPECT_EQ((FCircles{{"X", "Y"}}),
		FindCirclesOf({{"X.cpp", "#include \"Y.h\""}, {"X.h", ""}, {"Y.cpp", "#include \"X.h\""}, {"Y.h", ""}}));
}

TEST(IncludeGraph, EveryCircleIsFoundOnceAndWhole)
{
	EXPECT_EQ((FCircles{{"A", "B", "C"}, {"D", "E"}}),
		FindCirclesOf({{"A.h", "#include \"B.h\"\n#include \"D.h\""}, {"B.h", "#include \"C.h\""},
			{"C.h", "#include \"A.h\""}, {"D.h", "#include \"E.h\""}, {"E.h", "#include \"D.h\""}}));
}
