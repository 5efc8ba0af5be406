// A matrix as text and as JSON, against tables written by hand.
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "Matrix/MatrixSummary.h"
#include "Matrix/MatrixTable.h"
#include "Text/Json.h"

using namespace Drydock;

namespace
{

FMatrixRow MakeGood(int Minor, const std::string& Fingerprint, std::optional<int> Before)
{
	FMatrixRow Row;
	Row.Minor = Minor;
	Row.Build.bBuilt = true;
	Row.Build.Library = "out/libTint.so";
	Row.Run = FMatrixRun();
	Row.Run->Extensions = {"FTint"};
	Row.Picture = FMatrixPicture{Fingerprint, Before, std::nullopt, std::nullopt};
	return Row;
}

FMatrixRow MakeBroken(int Minor)
{
	FMatrixRow Row;
	Row.Minor = Minor;
	Row.Build.FirstError = FMatrixMessage{0, "Source/MyTint.cpp", 41, "", "'FSlice' was not declared in this scope"};
	return Row;
}

FMatrixRow MakeFailed(int Minor, int ExitCode, const FMatrixMessage& Error)
{
	FMatrixRow Row = MakeGood(Minor, "", std::nullopt);
	Row.Picture.reset();
	Row.Run->Extensions.clear();
	Row.Run->ExitCode = ExitCode;
	Row.Run->FirstError = Error;
	return Row;
}

const FMatrixMessage GCrash = {
	2086, "", 0, "plugin libTint.so, SetupView of extension FTint", "the plugin crashed: segmentation fault"};

FVersionMatrix MakeMatrix(std::vector<FMatrixRow> Rows)
{
	return {"MyTint", "/p/MyTint", "frame.json", false, "out", std::move(Rows)};
}

const std::string GOne = "0123456789abcdef0123456789abcdef";
const std::string GTwo = "fedcba9876543210fedcba9876543210";

} // namespace

TEST(MatrixTable, AllIsWell)
{
	FVersionMatrix Matrix = MakeMatrix({MakeGood(4, GOne, std::nullopt), MakeGood(5, GOne, 4)});
	Matrix.bStockConfig = true;
	EXPECT_EQ(R"(MyTint under engine 5.4 and 5.5, on drydock's own small frame

engine  builds  in the engine  compiler  runs  warnings  picture      first difference
5.4     yes     yes            -         yes   -         01234567     -
5.5     yes     yes            -         yes   -         same as 5.4  -

Builds, runs and draws the same under 5.4 and 5.5.
)",
		FormatMatrix(Matrix));
	EXPECT_EQ(ExitDone, GetMatrixExitCode(Matrix));
}

TEST(MatrixTable, NamesThatAVersionLacksOrDeprecates)
{
	FMatrixRow Lacks = MakeGood(4, GOne, std::nullopt);
	Lacks.Build.InEngine = {"A.cpp:3: engine 5.4 does not have FNew::F, which is there from 5.5 on (uncertain)",
		"A.cpp:4: engine 5.4 does not have ISceneViewExtension::GetFlags, which is there from 5.7 on"};
	FMatrixRow Unsure = MakeGood(5, GOne, 4);
	Unsure.Build.InEngine = {"A.cpp:3: engine 5.5 does not have FNew::G, which is there from 5.6 on (uncertain)"};
	FMatrixRow Old = MakeGood(8, GOne, 5);
	Old.Build.InEngine = {"A.cpp:5: engine 5.8 deprecates FCoreDelegates::OnPostEngineInit: use another"};
	const std::string Text = FormatMatrix(MakeMatrix({Lacks, Unsure, Old}));
	for (const char* const Part :
		{"no: ISceneViewExtension::GetFlags", "uncertain: FNew::G", "deprecated: FCoreDelegates::OnPostEngineInit",
			"5.8: A.cpp:5: that engine deprecates FCoreDelegates::OnPostEngineInit: use another"})
	{
		EXPECT_NE(std::string::npos, Text.find(Part)) << Text;
	}
}

TEST(MatrixTable, EverythingThatCanBe)
{
	FMatrixRow Other = MakeGood(6, GTwo, 4);
	Other.Picture->Difference = FPictureDifference{false, 0.0625, 1234, 3, 4};
	Other.FirstDifference = FPassDifference{"Tonemap 320x180", "draws something else"};
	Other.Run->Warnings = {{2070, "", 0, "extension FTint", "never called"},
		{2070, "", 0, "extension FTint", "never called"}, {2054, "", 0, "pass Tint", "reads its target"}};
	FMatrixRow Back = MakeGood(7, GOne, 6);
	Back.Picture->Difference = FPictureDifference{false, 0.0625, 1, 0, 0};
	Back.Picture->SameAs = 4;
	Back.FirstDifference = FPassDifference{"Tint", "is new"};
	Back.Build.Warnings = {{0, "MyTint.cpp", 12, "", "old"}, {0, "MyTint.cpp", 13, "", "older"}};
	const FVersionMatrix Matrix = MakeMatrix(
		{MakeBroken(1), MakeBroken(2), MakeGood(4, GOne, std::nullopt), MakeFailed(5, 71, GCrash), Other, Back});
	EXPECT_EQ(R"(MyTint under engine 5.1, 5.2 and 5.4 to 5.7, on frame.json

engine  builds             in the engine  compiler    runs                                   warnings           picture                                              first difference
5.1     no: MyTint.cpp:41  -              -           -                                      -                  -                                                    -
5.2     no: MyTint.cpp:41  -              -           -                                      -                  -                                                    -
5.4     yes                yes            -           yes                                    -                  01234567                                             -
5.5     yes                yes            -           crashes: SetupView of extension FTint  -                  -                                                    -
5.6     yes                yes            -           yes                                    DD2070 x2, DD2054  off by 0.0625 at 1234 pixels, first (3, 4)           Tonemap 320x180 draws something else
5.7     yes                yes            2 warnings  yes                                    -                  off by 0.0625 at 1 pixel, first (0, 0); same as 5.4  Tint is new

5.1 and 5.2: Source/MyTint.cpp:41: 'FSlice' was not declared in this scope
5.5: DD2086 at plugin libTint.so, SetupView of extension FTint: the plugin crashed: segmentation fault
5.6: DD2070 at extension FTint: never called
5.6: DD2054 at pass Tint: reads its target
5.7: the compiler warns: MyTint.cpp:12: old (and 1 more)

Builds and runs under 5.4, 5.6 and 5.7, and draws 2 pictures: one under 5.4 and 5.7; another under 5.6; 5.6 parts from 5.4 at pass Tonemap 320x180, which draws something else; 5.7 parts from 5.6 at pass Tint, which is new; 5.1 and 5.2: does not compile, 'FSlice' was not declared in this scope (Source/MyTint.cpp:41); 5.5: crashes: SetupView of extension FTint.
  what 5.1 and 5.2 do not have goes between #if !UE_VERSION_OLDER_THAN(5, 4, 0) and #endif (Misc/EngineVersionComparison.h)
  once more by itself: drydock run frame.json --engine 5.5 --plugin out/libTint.so
)",
		FormatMatrix(Matrix));
	EXPECT_EQ(ExitUsage, GetMatrixExitCode(Matrix));
}

TEST(MatrixTable, AMessageThatNamesTheVersionIsOne)
{
	FMatrixRow First = MakeGood(5, GOne, std::nullopt);
	First.Run->Warnings = {{2070, "", 0, "extension FTint", "which engine 5.5 never calls"}};
	FMatrixRow Second = MakeGood(6, GOne, 5);
	Second.Run->Warnings = {{2070, "", 0, "extension FTint", "which engine 5.6 never calls"}};
	const std::string Text = FormatMatrix(MakeMatrix({First, Second}));
	EXPECT_NE(std::string::npos, Text.find("\n5.5 and 5.6: DD2070 at extension FTint: which that engine never calls\n"))
		<< Text;
}

TEST(MatrixTable, WhereNothingBuildsItSaysSo)
{
	EXPECT_EQ("Fails under each of 5.1 and 5.2; 5.1 and 5.2: does not compile, 'FSlice' was not declared in this scope "
			  "(Source/MyTint.cpp:41).",
		SummarizeMatrix(MakeMatrix({MakeBroken(1), MakeBroken(2)})));
	EXPECT_TRUE(AdviseOnMatrix(MakeMatrix({MakeBroken(1), MakeBroken(2)})).empty());
}

TEST(MatrixTable, WhatOnlyOldVersionsHaveIsGuardedTheOtherWay)
{
	const std::vector<std::string> Advice =
		AdviseOnMatrix(MakeMatrix({MakeGood(5, GOne, std::nullopt), MakeBroken(6)}));
	ASSERT_EQ(1u, Advice.size());
	EXPECT_EQ("what 5.6 has no more goes between #if UE_VERSION_OLDER_THAN(5, 6, 0) and #endif "
			  "(Misc/EngineVersionComparison.h)",
		Advice[0]);
}

TEST(MatrixTable, APluginThatDoesNothingIsSaid)
{
	FVersionMatrix Matrix = MakeMatrix({MakeGood(4, GOne, std::nullopt)});
	Matrix.Rows[0].Run->Extensions.clear();
	EXPECT_EQ("Builds and runs under 5.4.", SummarizeMatrix(Matrix));
	EXPECT_EQ("no extension took part in the frame under 5.4, so the picture says nothing of the plugin: name a config "
			  "that switches it on",
		AdviseOnMatrix(Matrix).at(0));
}

TEST(MatrixTable, EndsOfRuns)
{
	FMatrixRun Run;
	Run.ExitCode = 2;
	EXPECT_EQ("exit 2", DescribeEnd(Run));
	Run.FirstError = FMatrixMessage{2015, "", 0, "pass X", "unset"};
	EXPECT_EQ("exit 2, DD2015", DescribeEnd(Run));
	Run.ExitCode = 139;
	Run.FirstError = FMatrixMessage{0, "", 0, "", "last line"};
	EXPECT_EQ("signal 11", DescribeEnd(Run));
	Run.ExitCode = 71;
	Run.FirstError = GCrash;
	EXPECT_EQ("crashes: SetupView of extension FTint", DescribeEnd(Run));
	Run.FirstError->Code = 2087;
	EXPECT_EQ("throws: SetupView of extension FTint", DescribeEnd(Run));
	Run.FirstError->Code = 2089;
	EXPECT_EQ("hangs: SetupView of extension FTint", DescribeEnd(Run));
}

TEST(MatrixTable, FilesAloneAreExitCodeThree)
{
	const FMatrixMessage Missing = {5001, "scene.exr", 0, "", "cannot be opened"};
	EXPECT_EQ(ExitFiles, GetMatrixExitCode(MakeMatrix({MakeFailed(4, 3, Missing), MakeFailed(5, 3, Missing)})));
	EXPECT_EQ(ExitUsage, GetMatrixExitCode(MakeMatrix({MakeFailed(4, 3, Missing), MakeFailed(5, 71, GCrash)})));
	EXPECT_EQ(ExitUsage, GetMatrixExitCode(MakeMatrix({MakeFailed(4, 71, GCrash), MakeFailed(5, 3, Missing)})));
	EXPECT_EQ(ExitFiles, GetMatrixExitCode(MakeMatrix({MakeGood(4, GOne, std::nullopt), MakeFailed(5, 3, Missing)})));
}

TEST(MatrixJson, HasAllOfIt)
{
	FMatrixRow Other = MakeGood(5, GTwo, 4);
	Other.Picture->Difference = FPictureDifference{false, 0.25, 7, 1, 2};
	Other.FirstDifference = FPassDifference{"Tint", "draws something else"};
	const FVersionMatrix Matrix =
		MakeMatrix({MakeBroken(3), MakeGood(4, GOne, std::nullopt), Other, MakeFailed(6, 71, GCrash)});
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(MakeMatrixJson(Matrix), "matrix.json", Diagnostics, bSyntaxError);
	ASSERT_FALSE(bSyntaxError);
	EXPECT_EQ("MyTint", Root.GetString("plugin"));
	EXPECT_EQ(SummarizeMatrix(Matrix), Root.GetString("summary"));
	EXPECT_FALSE(Root.Find("passed")->Bool);
	const std::vector<FJsonValue>& Versions = Root.GetElements("versions");
	ASSERT_EQ(4u, Versions.size());
	EXPECT_EQ("5.3", Versions[0].GetString("engine"));
	EXPECT_FALSE(Versions[0].Find("builds")->Bool);
	EXPECT_EQ(41.0, Versions[0].Find("firstError")->GetNumber("line", 0.0));
	EXPECT_EQ(EJsonType::Null, Versions[0].Find("run")->Type);
	EXPECT_EQ(GOne, Versions[1].Find("picture")->GetString("fingerprint"));
	EXPECT_EQ(EJsonType::Null, Versions[1].Find("picture")->Find("same")->Type);
	EXPECT_FALSE(Versions[2].Find("picture")->Find("same")->Bool);
	EXPECT_EQ("5.4", Versions[2].Find("picture")->GetString("before"));
	EXPECT_EQ(0.25, Versions[2].Find("picture")->GetNumber("max", 0.0));
	EXPECT_EQ(2.0, Versions[2].Find("picture")->GetElements("first").at(1).Number);
	EXPECT_EQ("Tint", Versions[2].Find("firstDifference")->GetString("pass"));
	EXPECT_EQ("DD2086", Versions[3].Find("run")->Find("firstError")->GetString("code"));
	EXPECT_EQ("crashes: SetupView of extension FTint", Versions[3].Find("run")->GetString("end"));
}
