// Tests of `drydock diff`: what it compares, and what it says by its exit code.
#include <gtest/gtest.h>

#include "Program/CommandLine.h"
#include "Text/ConfigErrors.h"
#include "Text/Json.h"

#include "Picture/ImageFile.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

class DiffVerb : public testing::Test
{
protected:
	DiffVerb()
		: Folder(Files::temp_directory_path() / ("drydock_diff_" + std::to_string(getpid())))
	{
		Files::remove_all(Folder);
		Files::create_directories(Folder / "a" / "passes");
		Files::create_directories(Folder / "b" / "passes");
	}
	~DiffVerb() override { Files::remove_all(Folder); }

	/** Two pixels, R and G. */
	std::string Write(const std::string& Name, const std::vector<double>& Values) const
	{
		const std::string Path = (Folder / Name).string();
		WriteExr(Path, {static_cast<int>(Values.size() / 2), 1, 2, Values}, {"R", "G"});
		return Path;
	}

	/** What `drydock diff A B --json` prints; sets ExitCode. */
	FJsonValue Call(const std::string& A, const std::string& B, const std::vector<std::string>& Options = {})
	{
		std::vector<std::string> Arguments = {"diff", A, B, "--json"};
		Arguments.insert(Arguments.end(), Options.begin(), Options.end());
		testing::internal::CaptureStdout();
		ExitCode = CallProgram(Arguments);
		std::vector<FDiagnostic> Diagnostics;
		bool bSyntaxError = false;
		return ParseJson(testing::internal::GetCapturedStdout(), "stdout", Diagnostics, bSyntaxError);
	}

	int ErrorOf(const std::string& A, const std::string& B)
	{
		try
		{
			CallProgram({"diff", A, B});
		}
		catch (const FError& Error)
		{
			return Error.GetDiagnostics()[0].Code;
		}
		return 0;
	}

	const Files::path Folder;
	int ExitCode = -1;
};

} // namespace

TEST_F(DiffVerb, GivesTheFiguresOfTwoImages)
{
	const FJsonValue Report = Call(Write("a.exr", {0.5, 1, 0.25, 1}), Write("b.exr", {0.5, 1, 0.75, 1}));
	const FJsonValue& Image = Report.Find("images")->Elements.at(0);
	EXPECT_EQ(0, ExitCode);
	EXPECT_EQ(0.5, Image.Find("max")->Number);
	EXPECT_EQ(0.25, Image.Find("rms")->Number); // sqrt(0.25 / 4)
	EXPECT_EQ(1, Image.Find("at")->Elements[0].Number);
	EXPECT_EQ("R", Image.Find("channel")->String);
}

TEST_F(DiffVerb, MaxDecidesTheExitCode)
{
	const std::string A = Write("a.exr", {0.5, 1});
	const std::string B = Write("b.exr", {0.75, 1});
	Call(A, B, {"--max", "0.25"});
	EXPECT_EQ(ExitDone, ExitCode);
	Call(A, B, {"--max", "0.24"});
	EXPECT_EQ(ExitPolicy, ExitCode);
}

TEST_F(DiffVerb, ImagesOfOtherSizesCannotBeCompared)
{
	EXPECT_EQ(ErrorImagesDiffer, ErrorOf(Write("a.exr", {1, 1}), Write("b.exr", {1, 1, 1, 1})));
}

TEST_F(DiffVerb, PartsOfAPictureAreComparedWhereTheyLie)
{
	const auto WritePart = [this](const std::string& Name, int X, int Y, double Second, int FullWidth = 16)
	{
		const std::string Path = (Folder / Name).string();
		WriteExr(Path, {2, 1, 1, {0.5, Second}}, {"R"}, {}, {X, Y, FullWidth, 8});
		return Path;
	};
	const std::string A = WritePart("a.exr", 4, 3, 0.25);
	const FJsonValue Same = Call(A, WritePart("b.exr", 4, 3, 0.75));
	EXPECT_EQ(0.5, Same.Find("images")->Elements.at(0).Find("max")->Number);
	EXPECT_EQ(5, Same.Find("images")->Elements.at(0).Find("at")->Elements[0].Number); // of the whole picture
	EXPECT_EQ(3, Same.Find("images")->Elements.at(0).Find("at")->Elements[1].Number);

	// 3 x 2 pixels hold both, and 0 beside them.
	const FJsonValue Moved = Call(A, WritePart("c.exr", 3, 4, 0.875));
	EXPECT_EQ(0.875, Moved.Find("images")->Elements.at(0).Find("max")->Number);
	EXPECT_EQ(4, Moved.Find("images")->Elements.at(0).Find("at")->Elements[0].Number);
	EXPECT_EQ(4, Moved.Find("images")->Elements.at(0).Find("at")->Elements[1].Number);
	EXPECT_NEAR(std::sqrt((0.5 * 0.5 + 0.25 * 0.25 + 0.5 * 0.5 + 0.875 * 0.875) / 6),
		Moved.Find("images")->Elements.at(0).Find("rms")->Number, 1e-12);
	EXPECT_EQ(ErrorImagesDiffer, ErrorOf(A, WritePart("d.exr", 4, 3, 0.25, 17)));
	EXPECT_EQ(ErrorImagesDiffer, ErrorOf(A, WritePart("e.exr", -1, 3, 0.25))); // beyond the whole
}

TEST_F(DiffVerb, MissingImageIsAFileError)
{
	EXPECT_EQ(ErrorFileMissing, ErrorOf((Folder / "none.exr").string(), Write("b.exr", {1, 1})));
}

TEST_F(DiffVerb, ImageAndFolderCannotBeCompared)
{
	EXPECT_EQ(ErrorImagesDiffer, ErrorOf(Write("a.exr", {1, 1}), (Folder / "b").string()));
}

TEST_F(DiffVerb, EmptyFoldersAreAnError)
{
	EXPECT_EQ(ErrorFileMissing, ErrorOf((Folder / "a").string(), (Folder / "b").string()));
}

TEST_F(DiffVerb, RunsArePairedByPassAlthoughTheirNumbersMove)
{
	Write("a/final.exr", {0, 0});
	Write("b/final.exr", {0, 0});
	Write("a/passes/003.Blur.Blur.exr", {1, 0});
	Write("b/passes/004.Blur.Blur.exr", {1, 0.5});
	Write("a/passes/005.Blur.Blur.exr", {2, 0}); // the second of that name
	Write("b/passes/006.Blur.Blur.exr", {2, 0});
	Write("b/passes/002.Setup.Setup.exr", {1, 1});
	const FJsonValue Report = Call((Folder / "a").string(), (Folder / "b").string(), {"--max", "1.0"});
	const std::vector<FJsonValue>& Images = Report.Find("images")->Elements;
	ASSERT_EQ(4u, Images.size());
	EXPECT_EQ("Blur.Blur", Images[0].Find("name")->String);
	EXPECT_EQ(0.5, Images[0].Find("max")->Number);
	EXPECT_EQ("Blur.Blur #2", Images[1].Find("name")->String);
	EXPECT_EQ(0.0, Images[1].Find("max")->Number);
	EXPECT_EQ("final", Images[2].Find("name")->String);
	EXPECT_EQ("Setup.Setup", Images[3].Find("name")->String);
	EXPECT_EQ("", Images[3].Find("a")->String);
	EXPECT_EQ(ExitPolicy, ExitCode); // one has a picture that the other lacks
}

TEST_F(DiffVerb, HeatMapIsAsLargeAsTheImages)
{
	const std::string HeatMap = (Folder / "maps" / "heat.png").string();
	Call(Write("a.exr", {0.5, 1, 0.25, 1}), Write("b.exr", {0.5, 1, 0.75, 1}), {"--heatmap", HeatMap});
	const FImageFile File(HeatMap);
	EXPECT_EQ(2, File.GetWidth());
	EXPECT_EQ(1, File.GetHeight());
}

TEST_F(DiffVerb, PngIsComparedAsItIsDisplayed)
{
	// 8-bit 51 and 102 are 0.2 and 0.4.
	const auto WriteGrey = [&](const std::string& Name, double Value)
	{
		const std::string Path = (Folder / Name).string();
		WritePng(Path, {1, 1, 3, {Value, Value, Value}});
		return Path;
	};
	const FJsonValue Report = Call(WriteGrey("a.png", 0.2), WriteGrey("b.png", 0.4));
	EXPECT_NEAR(0.2, Report.Find("images")->Elements[0].Find("max")->Number, 1e-6);
}
