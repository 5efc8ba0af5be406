// The shipped config whose second frame reads what SSRInput returned in the first: its picture from the formula.
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Sequence/RunSequence.h"
#include "SequenceTestUtils.h"

using namespace Drydock;
using namespace SequenceTest;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

/** Red, green and blue of a picture. */
std::vector<std::vector<float>> ReadColor(const std::string& Path)
{
	FImageFile File(Path);
	return File.Read({File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")});
}

/** The dumped EXR of that pass in a frame's folder. */
std::string FindDump(const Files::path& Frame, const std::string& Pass)
{
	for (const Files::directory_entry& Entry : Files::directory_iterator(Frame / "passes"))
	{
		const std::string Name = Entry.path().filename().string();
		if (Name.find("." + Pass) != std::string::npos && Entry.path().extension() == ".exr")
		{
			return Entry.path().string();
		}
	}
	ADD_FAILURE() << "no dump of " << Pass << " in " << Frame;
	return "";
}

} // namespace

TEST(LastFrame, TheSecondFrameShowsWhatSSRInputReturnedInTheFirst)
{
	const FTemporaryFolder Temporary("drydock_last_frame");
	FSequenceOptions Options;
	Options.Run.ConfigFile = Configs + "sequence_last_frame.json";
	Options.Run.Dump = {"GaussianBlurY", "RED.SoftFocus"};
	Options.Folder = (Temporary.Path / "out").string();
	EXPECT_EQ((std::vector<int>{1, 2}), RunSequence(Options).Frames);
	const Files::path Frames = Temporary.Path / "out/frames";
	const std::vector<std::vector<float>> Kept = ReadColor(FindDump(Frames / "0001", "GaussianBlurY"));
	for (const bool bSecond : {false, true})
	{
		const std::string Frame = bSecond ? "0002" : "0001";
		const std::vector<std::vector<float>> Scene = ReadColor(Configs + "scenes/moving_camera." + Frame + ".exr");
		const std::vector<std::vector<float>> Shown = ReadColor(FindDump(Frames / Frame, "RED_SoftFocus"));
		for (size_t Channel = 0; Channel < 3; ++Channel)
		{
			ASSERT_EQ(Scene[Channel].size(), Shown[Channel].size());
			for (size_t Pixel = 0; Pixel < Shown[Channel].size(); ++Pixel)
			{
				const double Last = bSecond ? static_cast<double>(Kept[Channel][Pixel]) : 0.0; // black at first
				const double Expected = 0.7 * static_cast<double>(Scene[Channel][Pixel]) + 0.3 * Last;
				ASSERT_NEAR(Expected, static_cast<double>(Shown[Channel][Pixel]), 1e-4 + Expected / 1024)
					<< Frame << ", pixel " << Pixel;
			}
		}
	}
}
