// Videos by a program that stands for ffmpeg: what it is given, and what becomes of its failures. And the words of the
// progress bar.
#include <gtest/gtest.h>

#include "Program/ProgressBar.h"
#include "Sequence/Video.h"
#include "SequenceTestUtils.h"

#include <cstdlib>

using namespace Drydock;
using namespace SequenceTest;

namespace
{

class Video : public testing::Test
{
protected:
	Video()
		: OldPath(std::getenv("PATH"))
	{
		setenv("PATH", Temporary.Path.c_str(), 1);
		std::ofstream(Temporary.Path / "1.png") << "one";
		std::ofstream(Temporary.Path / "2.png") << "two";
	}
	~Video() override { setenv("PATH", OldPath.c_str(), 1); }

	/** A program whose last argument is $Last, a file and not an address. */
	void Install(const std::string& Script) const
	{
		std::ofstream(Temporary.Path / "ffmpeg") << "#!/bin/sh\nfor Last; do :; done\n"
													"case $Last in file:*) Last=${Last#file:};; *) exit 2;; esac\n"
												 << Script << "\n";
		Files::permissions(Temporary.Path / "ffmpeg", Files::perms::owner_all);
	}

	std::string Make() const
	{
		return MakeVideo({(Temporary.Path / "1.png").string(), (Temporary.Path / "2.png").string()}, 24.0,
			(Temporary.Path / "a b/it's.mp4").string());
	}

	const FTemporaryFolder Temporary{"drydock_video"};
	const std::string OldPath;
};

} // namespace

TEST_F(Video, PicturesGoThroughInOrder)
{
	Install("/bin/cat > \"$Last\"");
	EXPECT_EQ("", Make());
	EXPECT_EQ("onetwo", ReadBytes(Temporary.Path / "a b/it's.mp4"));
}

TEST_F(Video, RateIsTheScenes)
{
	Install("echo \"$@\" > \"$Last\"; /bin/cat > /dev/null");
	EXPECT_EQ("", Make());
	EXPECT_NE(std::string::npos, ReadBytes(Temporary.Path / "a b/it's.mp4").find("-framerate 24 "));
}

TEST_F(Video, WithoutFfmpegOneSentenceSaysSo)
{
	EXPECT_EQ("ffmpeg is not on the PATH (Debian: apt install ffmpeg); the frames are complete", Make());
}

TEST_F(Video, FailureLeavesNothingBehind)
{
	Install("echo half > \"$Last\"; exit 1");
	EXPECT_EQ("ffmpeg failed; its messages are above", Make());
	EXPECT_TRUE(Files::is_empty(Temporary.Path / "a b"));
}

TEST(ProgressRate, IsOfWhatWasDone)
{
	EXPECT_EQ("", DescribeRate(0, 8, 3.0));
	EXPECT_EQ("2.0 frames/s, 3 s left", DescribeRate(4, 6, 2.0));
	EXPECT_EQ("0.5 frames/s, 3 min 20 s left", DescribeRate(1, 100, 2.0));
	EXPECT_EQ("0.1 frames/s, 2 h 46 min left", DescribeRate(1, 1000, 10.0)); // 10000 s
}
