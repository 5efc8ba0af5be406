// Lists of engine versions: as the command line has them, and as sentences do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "EngineProfile.h"
#include "Matrix/MatrixErrors.h"
#include "Matrix/MatrixVersions.h"

using namespace Drydock;

namespace
{

using FMinors = std::vector<int>;

std::string Refuse(const std::string& Text)
{
	try
	{
		ParseMatrixVersions(Text);
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_EQ(ErrorMatrixVersions, Error.GetDiagnostics().front().Code);
		return Error.GetDiagnostics().front().Message;
	}
	return "";
}

} // namespace

TEST(MatrixVersions, AreRangesAndSingleOnes)
{
	EXPECT_EQ((FMinors{3, 4, 5, 6, 8}), ParseMatrixVersions("5.3-5.6,5.8"));
	EXPECT_EQ((FMinors{2, 5}), ParseMatrixVersions(" 5.5 , 5.2, 5.5"));
	EXPECT_EQ((FMinors{7}), ParseMatrixVersions("5.7-5.7"));
}

TEST(MatrixVersions, OfNothingAreAllThatThereAre)
{
	EXPECT_EQ((FMinors{1, 2, 3, 4, 5, 6, 7, 8}), ParseMatrixVersions(""));
}

TEST(MatrixVersions, ThatAreUnknownAreAMistakeWithTheKnownOnes)
{
	EXPECT_THAT(Refuse("5.3,4.27"), testing::HasSubstr("\"4.27\" is not an engine version"));
	EXPECT_THAT(Refuse("5.9"), testing::HasSubstr("5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7, 5.8"));
	EXPECT_THAT(Refuse("5.6-5.3"), testing::HasSubstr("\"5.6-5.3\" ends before it begins"));
	for (const char* const Broken : {",", "5.3-", "-5.3", "5.3,,5.4", "5", "all", "5.3-5.4-5.5", "5.30"})
	{
		EXPECT_NE("", Refuse(Broken)) << Broken;
	}
}

TEST(MatrixVersions, AreDescribedByRanges)
{
	EXPECT_EQ("5.4", DescribeVersions({4}));
	EXPECT_EQ("5.1 and 5.2", DescribeVersions({1, 2}));
	EXPECT_EQ("5.1 to 5.3", DescribeVersions({1, 2, 3}));
	EXPECT_EQ("5.1, 5.3 to 5.6 and 5.8", DescribeVersions({1, 3, 4, 5, 6, 8}));
	EXPECT_EQ("5.2, 5.4 and 5.5", DescribeVersions({2, 4, 5}));
	EXPECT_EQ("", DescribeVersions({}));
}
