// Paths: what is read, and what is said of mistakes.
#include <gtest/gtest.h>

#include "Blend/WalkPath.h"

using namespace Drydock;

namespace
{

struct FRead
{
	std::vector<FPathPoint> Points;
	std::vector<FDiagnostic> Diagnostics;
};

FRead Read(const std::string& Text)
{
	FRead Result;
	Result.Points = ReadPath(Text, "path.json", Result.Diagnostics);
	return Result;
}

/** "1006 1:14 expected ..." of the only message. */
std::string Only(const std::string& Text)
{
	const FRead Result = Read(Text);
	if (Result.Diagnostics.size() != 1)
	{
		return std::to_string(Result.Diagnostics.size()) + " messages";
	}
	const FDiagnostic& Diagnostic = Result.Diagnostics[0];
	return std::to_string(Diagnostic.Code) + " " + std::to_string(Diagnostic.Line) + ":" +
		   std::to_string(Diagnostic.Column) + " " + Diagnostic.Message;
}

} // namespace

TEST(WalkPath, ReadsLocationsAndLabels)
{
	const FRead Result = Read(R"([{"location": [1, 2, 3]}, {"location": [4, 5.5, -6], "t": 0.25},
		{"location": [7, 8, 9], "t": 0.5, "frame": 12}])");
	EXPECT_TRUE(Result.Diagnostics.empty());
	ASSERT_EQ(3u, Result.Points.size());
	EXPECT_EQ(FVector(4.0, 5.5, -6.0), Result.Points[1].Location);
	EXPECT_EQ("1", Result.Points[0].Label);
	EXPECT_EQ("0.25", Result.Points[1].Label);
	EXPECT_EQ("12", Result.Points[2].Label);
}

TEST(WalkPath, MistakesHaveLineAndColumn)
{
	const std::string Good = R"({"location": [0, 0, 0]})";
	EXPECT_EQ("1006 1:1 expected an array of points, found an object", Only(Good));
	EXPECT_EQ("1009 1:1 a path has two points or more", Only("[" + Good + "]"));
	EXPECT_EQ("1008 2:1 the point has no \"location\"", Only("[" + Good + ",\n{}]"));
	EXPECT_EQ("1006 2:14 expected [x, y, z] in cm", Only("[" + Good + ",\n{\"location\": [1, 2]}]"));
	EXPECT_EQ("1006 2:14 expected [x, y, z] in cm", Only("[" + Good + ",\n{\"location\": [1, 2, \"3\"]}]"));
	EXPECT_EQ("1006 2:2 expected a point {\"location\": [x, y, z]}, found a number", Only("[" + Good + ",\n 5]"));
	EXPECT_EQ(
		"1005 2:25 unknown key; did you mean frame?", Only("[" + Good + ",\n{\"location\": [1, 2, 3], \"frme\": 1}]"));
	EXPECT_EQ("1006 2:34 expected a whole number, found 1.5",
		Only("[" + Good + ",\n{\"location\": [1, 2, 3], \"frame\": 1.5}]"));
}

TEST(WalkPath, SyntaxErrorEndsIt)
{
	EXPECT_EQ("1001", Only("[{]").substr(0, 4));
}

TEST(WalkPath, AllMistakesAreReported)
{
	EXPECT_EQ(3u, Read(R"([{}, 1, {"location": true}])").Diagnostics.size());
}
