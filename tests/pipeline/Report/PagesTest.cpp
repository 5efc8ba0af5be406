// The pages of `drydock diff`, of a sequence, of `drydock matrix` and of a sweep: when they are written, what they
// refuse, the form of their data, and how small pictures get.
#include <gtest/gtest.h>

#include "Matrix/MatrixTable.h"
#include "PageTestUtils.h"
#include "Picture/ImageMetrics.h"
#include "Picture/PictureFile.h"
#include "Report/MatrixPage.h"
#include "Report/PortablePaths.h"
#include "Report/ReportPng.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace Drydock;
using namespace ProgramTest;
using namespace ReportTest;

namespace
{

std::vector<std::string> CheckData(const FJson& Data, const std::string& Schema)
{
	const FJson Read = ReadSchemaFile(Schema);
	return FSchemaCheck(Read).Check(Data);
}

/** A frame with weak bloom into a, with strong bloom into b. */
void RunTwo(const FProgramFolder& Folder)
{
	Folder.WriteFrame("frame.json", R"(, "outputs": {"dump": ["BloomSetup"]})");
	EXPECT_EQ(0, Folder.Call("run frame.json --out a").ExitCode);
	EXPECT_EQ(0, Folder.Call("run frame.json --out b --pp BloomIntensity=4").ExitCode);
}

const std::string Walk = "run '" DRYDOCK_TEST_SOURCE_DIR "/configs/volumes_walk.json' --out out/walk ";

/** Bytes that no PNG makes smaller. */
std::string MakeNoise(int Width, int Height)
{
	std::mt19937 Random(1);
	FImage Image{Width, Height, 3, {}};
	for (int Value = 0; Value < Width * Height * 3; ++Value)
	{
		Image.Values.push_back(static_cast<double>(Random() % 256) / 255.0);
	}
	return MakePng(Image, true);
}

FImage ReadPng(const FProgramFolder& Folder, const std::string& Bytes)
{
	Folder.Write("picture.png", Bytes);
	return ReadPicture((Folder.Path / "picture.png").string());
}

} // namespace

TEST(DiffPage, IsWrittenWhereItIsAskedForAndOfItsForm)
{
	const FProgramFolder Folder("page_diff");
	RunTwo(Folder);
	const std::string Table = Folder.Call("diff a b").Printed;
	EXPECT_FALSE(Files::exists(Folder.Path / "out"));
	EXPECT_EQ(Table + "page     out/diff/diff.html\n", Folder.Call("diff a b --report").Printed);
	const FJson Data = ReadData(Folder, "out/diff/diff.html");
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "diff.schema.json"));
	EXPECT_EQ(FJson::parse(Folder.Call("diff a b --json").Printed), Data["diff"]);
	EXPECT_EQ(FJson::parse(Folder.Read("b/run.json")), Data["b"]["run"]);
	std::set<std::string> Ids;
	for (const FJson& Picture : Data["pictures"])
	{
		Ids.insert(Picture["id"]);
	}
	for (const FJson& Image : Data["diff"]["images"])
	{
		const std::string Name = Image["name"];
		EXPECT_EQ(1u, Ids.count("a: " + Name));
		EXPECT_EQ(Image["max"] != 0, Ids.count("b: " + Name) == 1) << Name;
		EXPECT_EQ(Image["max"] != 0, Ids.count("error: " + Name) == 1) << Name;
	}
	EXPECT_NE(0, Data["diff"]["images"].back()["max"]);
}

TEST(DiffPage, IsWrittenOfPicturesTooAndWhereTheyDifferTooMuch)
{
	const FProgramFolder Folder("page_diff_max");
	RunTwo(Folder);
	EXPECT_EQ(1, Folder.Call("diff a/final.png b/final.png --max 0 --report --out page").ExitCode);
	const FJson Data = ReadData(Folder, "page/diff.html");
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "diff.schema.json"));
	EXPECT_EQ("final.png against final.png", Data["name"]);
	EXPECT_FALSE(Data["diff"]["passed"].get<bool>());
	EXPECT_FALSE(Data["a"].contains("run"));
	EXPECT_EQ(2, Folder.Call("diff a b --report loud").ExitCode);
}

TEST(DiffPage, APageThatSomebodyElsePutThereIsNotReplaced)
{
	const FProgramFolder Folder("page_diff_foreign");
	RunTwo(Folder);
	Folder.Write("out/diff/diff.html", "mine");
	const FOutcome Outcome = Folder.Call("diff a b --report");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("DD1080")) << Outcome.Printed;
	EXPECT_EQ("mine", Folder.Read("out/diff/diff.html"));
}

TEST(SequencePage, HasEveryFrameItsFiguresAndTheWalk)
{
	const FProgramFolder Folder("page_sequence");
	EXPECT_EQ(0, Folder.Call(Walk + "--frames 1-3").ExitCode);
	EXPECT_FALSE(Files::exists(Folder.Path / "out/walk/sequence.html"));
	const FOutcome Asked = Folder.Call(Walk + "--frames 1-3 --report");
	EXPECT_NE(std::string::npos, Asked.Printed.find("page     out/walk/sequence.html\n")) << Asked.Printed;
	const FJson Data = ReadData(Folder, "out/walk/sequence.html");
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "sequence.schema.json"));
	EXPECT_EQ(FJson::parse(MakePathsPortable(Folder.Read("out/walk/sequence.json"))), Data["sequence"]);
	ASSERT_EQ(3u, Data["figures"].size());
	ASSERT_EQ(3u, Data["pictures"].size());
	const FImageError Step = CompareImages(ReadPicture((Folder.Path / "out/walk/frames/0003/final.png").string()),
		ReadPicture((Folder.Path / "out/walk/frames/0002/final.png").string()));
	EXPECT_NEAR(Step.Rms, Data["figures"][2]["change"].get<double>(), 1e-12);
	EXPECT_TRUE(Data["figures"][0]["change"].is_null());
	const FJson& Chart = Data["walk"]["chart"];
	const auto HasTitle = [](const FJson& Panel)
	{
		return Panel["title"] != "";
	};
	EXPECT_GT(std::count_if(Chart["panels"].begin(), Chart["panels"].end(), HasTitle), 2);
	EXPECT_EQ(8u, Chart["panels"].back()["series"][0]["points"].size());
	EXPECT_EQ(8u, Chart["marks"].size()) << "the path is that of all frames of the scene";
}

TEST(SequencePage, GoesWhenItsFramesDoAndIsNotPutOverSomebodyElses)
{
	const FProgramFolder Folder("page_sequence_restart");
	EXPECT_EQ(0, Folder.Call(Walk + "--frames 1-2 --report").ExitCode);
	EXPECT_EQ(0, Folder.Call(Walk + "--frames 1-2").ExitCode);
	EXPECT_TRUE(Files::exists(Folder.Path / "out/walk/sequence.html")) << "nothing was rendered that it does not show";
	EXPECT_EQ(0, Folder.Call(Walk + "--frames 1-3").ExitCode);
	EXPECT_FALSE(Files::exists(Folder.Path / "out/walk/sequence.html"));
	Folder.Write("out/walk/sequence.html", "mine");
	const FOutcome Outcome = Folder.Call(Walk + "--frames 1-3 --report");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Printed.find("DD1080")) << Outcome.Printed;
	EXPECT_EQ("mine", Folder.Read("out/walk/sequence.html"));
}

TEST(RunPage, OfAFrameOfASequenceHasTheWalk)
{
	const FProgramFolder Folder("page_walk");
	EXPECT_EQ(0, Folder.Call(Walk + "--frame 4 --report").ExitCode);
	const FJson Data = ReadData(Folder, "out/walk/report.html");
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "report.schema.json"));
	EXPECT_EQ("4", Data["walk"]["at"]);
}

TEST(MatrixPage, HasTheTableAndThePicturesThatDiffer)
{
	const FProgramFolder Folder("page_matrix");
	Folder.Write("final.png", MakeNoise(20, 10));
	FVersionMatrix Matrix;
	Matrix.Name = "MyTint";
	Matrix.Rows.resize(1);
	Matrix.Rows[0].Minor = 4;
	Matrix.Rows[0].Build.FirstError = FMatrixMessage{.File = "MyTint.cpp", .Line = 41, .Text = "no </script>"};
	const FJson Data = FJson::parse(MakeMatrixPageData(
		{"MyTint", MakeMatrixJson(Matrix), {{"5.4", (Folder.Path / "final.png").string()}}}, "2025-01-31T12:00:00Z"));
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "matrix.schema.json"));
	EXPECT_EQ("no </script>", Data["matrix"]["versions"][0]["firstError"]["text"]);
	EXPECT_EQ("5.4", Data["pictures"][0]["id"]);
	EXPECT_EQ(FJson({20, 10}), Data["pictures"][0]["size"]);
}

TEST(SweepPage, HasTheTableThePlotsAndAPictureOfEachTask)
{
	const FProgramFolder Folder("page_sweep");
	Folder.WriteFrame("sweep.json",
		R"(, "sweep": {"axes": [{"name": "r.BloomQuality", "values": [1, 5]}, {"name": "BloomIntensity", "values": [1, 2]}]})");
	EXPECT_EQ(0, Folder.Call("sweep plan sweep.json --out out").ExitCode);
	EXPECT_EQ(0, Folder.Call("sweep submit out").ExitCode);
	const FJson Data = ReadData(Folder, "out/sweep.html");
	EXPECT_EQ(std::vector<std::string>(), CheckData(Data, "sweep.schema.json"));
	EXPECT_EQ(FJson::parse(Folder.Read("out/table.json")), Data["sweep"]);
	EXPECT_EQ(4u, Data["pictures"].size());
	EXPECT_EQ(2u, Data["plots"].size());
	EXPECT_EQ(2u, Data["plots"][1]["panels"][0]["series"].size());
}

TEST(FitPictures, HalvesTheHeaviestTogetherUntilAllFit)
{
	const FProgramFolder Folder("page_fit");
	std::vector<FReportPicture> Pictures(4);
	Pictures[0].Png = Pictures[1].Png = MakeNoise(512, 512);
	Pictures[2].Png = Pictures[3].Png = MakeNoise(256, 256);
	FitPictures(Pictures, {{0, 1}, {2, 3}}, 10'000'000);
	EXPECT_EQ(512, ReadPng(Folder, Pictures[0].Png).Width) << "they fitted already";
	FitPictures(Pictures, {{0, 1}, {2, 3}}, 1'000'000);
	EXPECT_EQ(256, ReadPng(Folder, Pictures[0].Png).Width);
	EXPECT_EQ(256, ReadPng(Folder, Pictures[1].Png).Width);
	EXPECT_EQ(256, ReadPng(Folder, Pictures[3].Png).Width);
	FitPictures(Pictures, {{0, 1}, {2, 3}}, 1);
	EXPECT_EQ(128, ReadPng(Folder, Pictures[0].Png).Width) << "what is narrower tells nothing";
}

TEST(MakePng, TakesTwoAndFourChannelsForColours)
{
	const FProgramFolder Folder("page_png");
	const FImage Four = ReadPng(Folder, MakePng(FImage{1, 1, 4, {0.2, 0.4, 0.6, 0.0}}, true));
	EXPECT_NEAR(0.2, Four.Get(0, 0, 0), 0.5 / 255);
	EXPECT_NEAR(0.6, Four.Get(0, 0, 2), 0.5 / 255);
	const FImage Two = ReadPng(Folder, MakePng(FImage{1, 1, 2, {0.2, 0.4}}, true));
	EXPECT_NEAR(0.4, Two.Get(0, 0, 1), 0.5 / 255);
	EXPECT_EQ(0.0, Two.Get(0, 0, 2));
}
