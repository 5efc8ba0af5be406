// Scene files with ####: which frames there are, and which one is taken.
#include <gtest/gtest.h>

#include "Config/FrameSequence.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace Drydock;

namespace
{

struct FrameSequence : testing::Test
{
	FrameSequence()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_frames_" + std::to_string(getpid())))
	{
		std::filesystem::remove_all(Folder);
		std::filesystem::create_directories(Folder);
		for (const char* Name : {"walk.0002.exr", "walk.0010.exr", "walk.12345.exr", "walk.002.exr", "walk.00002.exr",
				 "walk.000x.exr", "walk.-002.exr", "run.0001.exr", "walk.0003.json", "walk..exr"})
		{
			std::ofstream(Folder / Name) << "x";
		}
	}
	~FrameSequence() override { std::filesystem::remove_all(Folder); }

	FConfig MakeConfig(const std::string& File) const
	{
		FConfig Config;
		Config.File = (Folder / "a.json").string();
		Config.Scene.File = {File, {3, 7, "/scene/file"}};
		return Config;
	}

	std::string ErrorOf(const std::string& File, std::optional<int> Frame) const
	{
		FConfig Config = MakeConfig(File);
		try
		{
			ChooseSceneFrame(Config, Frame);
		}
		catch (const FError& Error)
		{
			const FDiagnostic& First = Error.GetDiagnostics().at(0);
			return std::to_string(Error.GetExitCode()) + " " + std::to_string(First.Line) + ":" +
				   std::to_string(First.Column) + " " + First.Message;
		}
		return "none";
	}

	const std::filesystem::path Folder;
};

} // namespace

TEST_F(FrameSequence, HasARowOfMarksInItsName)
{
	EXPECT_TRUE(IsFrameSequence("scenes/walk.####.exr"));
	EXPECT_FALSE(IsFrameSequence("scenes/walk.0001.exr"));
	EXPECT_FALSE(IsFrameSequence("scenes/take#2/walk.exr"));
}

TEST_F(FrameSequence, FramesAreSortedByNumber)
{
	const std::vector<FSequenceFrame> Expected = {{2, (Folder / "walk.0002.exr").string()},
		{10, (Folder / "walk.0010.exr").string()}, {12345, (Folder / "walk.12345.exr").string()}};
	EXPECT_EQ(Expected, FindSequenceFrames((Folder / "walk.####.exr").string()));
}

TEST_F(FrameSequence, FolderThatIsNotThereHasNone)
{
	EXPECT_TRUE(FindSequenceFrames((Folder / "nowhere/walk.####.exr").string()).empty());
}

TEST_F(FrameSequence, LowestFrameIsTakenByDefault)
{
	FConfig Config = MakeConfig("walk.####.exr");
	ChooseSceneFrame(Config, std::nullopt);
	EXPECT_EQ("walk.0002.exr", Config.Scene.File.Value);
	EXPECT_EQ("walk.####.exr", Config.Scene.Sequence);
	EXPECT_EQ(2, Config.Scene.Frame);
}

TEST_F(FrameSequence, AFrameIsTakenByItsNumber)
{
	FConfig Config = MakeConfig("walk.####.exr");
	ChooseSceneFrame(Config, 10);
	EXPECT_EQ("walk.0010.exr", Config.Scene.File.Value);
}

TEST_F(FrameSequence, OtherScenesStayAsTheyAre)
{
	FConfig Config = MakeConfig("walk.0010.exr");
	ChooseSceneFrame(Config, 3);
	EXPECT_EQ("walk.0010.exr", Config.Scene.File.Value);
	EXPECT_EQ("", Config.Scene.Sequence);
}

TEST_F(FrameSequence, MissingFramesAreFileErrorsAtTheirPlace)
{
	EXPECT_EQ("3 3:7 there is no frame 3 of " + (Folder / "walk.####.exr").string() + ": there are 2 to 12345",
		ErrorOf("walk.####.exr", 3));
	EXPECT_EQ("3 3:7 no file matches " + (Folder / "fly.##.exr").string(), ErrorOf("fly.##.exr", std::nullopt));
}
