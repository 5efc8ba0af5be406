// Pictures in files: exact round trips, equal bytes, one read of chosen channels, and files that are not what they
// seem.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <unistd.h>

using namespace Drydock;

namespace
{

const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";

/** A folder of this test, gone afterwards. */
class ImageFile : public testing::Test
{
protected:
	ImageFile()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_image_" + std::to_string(getpid())))
	{
		std::filesystem::create_directories(Folder);
	}
	~ImageFile() override { std::filesystem::remove_all(Folder); }

	std::string Path(const std::string& Name) const { return (Folder / Name).string(); }

	const std::filesystem::path Folder;
};

std::string ReadBytes(const std::string& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

/** Code and exit code of opening and reading all of a file. */
std::pair<int, int> ErrorOf(const std::string& Path)
{
	try
	{
		FImageFile File(Path);
		std::vector<int> All;
		for (int Channel = 0; Channel < static_cast<int>(File.GetChannels().size()); ++Channel)
		{
			All.push_back(Channel);
		}
		File.Read(All);
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(1u, Error.GetDiagnostics().size());
		EXPECT_EQ(std::string::npos, Error.GetDiagnostics()[0].Message.find('\n'));
		return {Error.GetDiagnostics()[0].Code, Error.GetExitCode()};
	}
	return {0, 0};
}

/** Most memory that this process has held; 0 where the system does not say. */
int64_t GetPeakKilobytes()
{
	std::ifstream Status("/proc/self/status");
	for (std::string Line; std::getline(Status, Line);)
	{
		if (Line.starts_with("VmHWM:"))
		{
			return std::atoll(Line.c_str() + 6);
		}
	}
	return 0;
}

std::vector<double> DrawNoise(size_t Count)
{
	std::mt19937 Random(16);
	std::uniform_real_distribution<double> Value(0.0, 1.0);
	std::vector<double> Values(Count);
	std::generate(Values.begin(), Values.end(), [&] { return Value(Random); });
	return Values;
}

const FImage TwoPixels{2, 1, 3, {0.0, 0.25, 1.5, -2.0, 65504.0, 1e-7}};

} // namespace

TEST_F(ImageFile, ExrKeepsFloatsExactly)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"});
	FImageFile File(Path("a.exr"));
	EXPECT_EQ(2, File.GetWidth());
	EXPECT_EQ((std::vector<std::vector<float>>{{0.0f, -2.0f}, {0.25f, 65504.0f}, {1.5f, 1e-7f}}), File.Read({0, 1, 2}));
}

TEST_F(ImageFile, ExrOfAPartSaysWhereItLies)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"}, {}, {5, 3, 16, 8});
	FImageFile File(Path("a.exr"));
	EXPECT_EQ((FImageWindow{5, 3, 16, 8}), File.GetWindow());
	EXPECT_EQ(2, File.GetWidth());
	EXPECT_EQ(1, File.GetHeight());
	EXPECT_EQ((std::vector<std::vector<float>>{{0.0f, -2.0f}}), File.Read({0}));
	const std::unique_ptr<OIIO::ImageInput> Seen = OIIO::ImageInput::open(Path("a.exr"));
	EXPECT_EQ(5, Seen->spec().x);
	EXPECT_EQ(16, Seen->spec().full_width);
}

TEST_F(ImageFile, TheDisplayWindowIsThePictureWhereItIsAskedFor)
{
	FImage Numbers{4, 3, 1, {}};
	for (int Pixel = 0; Pixel < 12; ++Pixel)
	{
		Numbers.Values.push_back(1.0 + Pixel);
	}
	const FImageWindow Windows[] = {{-1, -1, 2, 2}, {1, 1, 6, 5}, {-2, 1, 5, 3}, {2, -2, 4, 4}, {0, 0, 4, 3},
		{50, 0, 3, 2}, {-40, -40, 1, 1}, {-3, -2, 1, 1}};
	for (const FImageWindow& At : Windows)
	{
		WriteExr(Path("a.exr"), Numbers, {"R"}, {}, At);
		FImageFile File(Path("a.exr"), EImageExtent::Display);
		ASSERT_EQ(At.FullWidth, File.GetWidth());
		ASSERT_EQ(At.FullHeight, File.GetHeight());
		const std::vector<float> Plane = File.Read({0})[0];
		for (int Y = 0; Y < At.FullHeight; ++Y)
		{
			for (int X = 0; X < At.FullWidth; ++X)
			{
				const int FromX = X - At.X, FromY = Y - At.Y;
				const bool bStored = FromX >= 0 && FromX < 4 && FromY >= 0 && FromY < 3;
				EXPECT_EQ(bStored ? 1.0f + static_cast<float>(FromY * 4 + FromX) : 0.0f,
					Plane.at(static_cast<size_t>(Y * At.FullWidth + X)))
					<< X << ", " << Y << " of " << At.X << ", " << At.Y;
			}
		}
		EXPECT_EQ((At == FImageWindow{0, 0, 4, 3}), File.DescribeExtent().empty());
		EXPECT_EQ("", FImageFile(Path("a.exr")).DescribeExtent());
	}
	WriteExr(Path("a.exr"), Numbers, {"R"}, {}, {0, 0, 1 << 20, 1});
	EXPECT_THROW(FImageFile(Path("a.exr"), EImageExtent::Display), FError);
	EXPECT_EQ(4, FImageFile(Path("a.exr")).GetWidth());
}

TEST_F(ImageFile, AWholePictureIsItsOwnWindow)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"});
	EXPECT_EQ((FImageWindow{0, 0, 2, 1}), FImageFile(Path("a.exr")).GetWindow());
	WritePng(Path("a.png"), TwoPixels);
	EXPECT_EQ((FImageWindow{0, 0, 2, 1}), FImageFile(Path("a.png")).GetWindow());
}

TEST_F(ImageFile, ExrKeepsNonFiniteValues)
{
	WriteExr(Path("a.exr"), {2, 1, 1, {std::nan(""), std::numeric_limits<double>::infinity()}}, {"R"});
	const std::vector<std::vector<float>> Planes = FImageFile(Path("a.exr")).Read({0});
	EXPECT_TRUE(std::isnan(Planes[0][0]));
	EXPECT_TRUE(std::isinf(Planes[0][1]));
}

TEST_F(ImageFile, ExrIsHalfOnlyWhereThatLosesNothing)
{
	WriteExr(Path("half.exr"), {2, 1, 1, {65504.0, 1.0 / 16777216.0}}, {"R"}); // the largest and the least half
	WriteExr(Path("float.exr"), {2, 1, 1, {65505.0, 0.1}}, {"R"});
	EXPECT_EQ(OIIO::TypeDesc(OIIO::TypeDesc::HALF), OIIO::ImageInput::open(Path("half.exr"))->spec().format);
	EXPECT_EQ(OIIO::TypeDesc(OIIO::TypeDesc::FLOAT), OIIO::ImageInput::open(Path("float.exr"))->spec().format);
	EXPECT_EQ(
		(std::vector<std::vector<float>>{{65504.0f, 1.0f / 16777216.0f}}), FImageFile(Path("half.exr")).Read({0}));
	EXPECT_EQ((std::vector<std::vector<float>>{{65505.0f, 0.1f}}), FImageFile(Path("float.exr")).Read({0}));
}

TEST_F(ImageFile, ReadsOnlyTheChannelsAsked)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"});
	EXPECT_EQ((std::vector<std::vector<float>>{{1.5f, 1e-7f}, {0.0f, -2.0f}}), FImageFile(Path("a.exr")).Read({2, 0}));
	EXPECT_TRUE(FImageFile(Path("a.exr")).Read({}).empty());
}

TEST_F(ImageFile, EqualPicturesAreEqualBytes)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"}, {{"drydock:encoding", "sRGB"}});
	WritePng(Path("a.png"), TwoPixels);
	sleep(1); // a date would show
	WriteExr(Path("b.exr"), TwoPixels, {"R", "G", "B"}, {{"drydock:encoding", "sRGB"}});
	WritePng(Path("b.png"), TwoPixels);
	EXPECT_EQ(ReadBytes(Path("a.exr")), ReadBytes(Path("b.exr")));
	EXPECT_EQ(ReadBytes(Path("a.png")), ReadBytes(Path("b.png")));
}

TEST_F(ImageFile, AttributesAreKept)
{
	WriteExr(Path("a.exr"), TwoPixels, {"R", "G", "B"}, {{"drydock:encoding", "sRGB"}});
	EXPECT_EQ("sRGB", FImageFile(Path("a.exr")).GetAttribute("drydock:encoding"));
	EXPECT_EQ("", FImageFile(Path("a.exr")).GetAttribute("none"));
}

TEST_F(ImageFile, PngRoundsClampsAndTakesNaNAsBlack)
{
	// 127.5 / 255 rounds up, 127.4 / 255 down.
	WritePng(Path("a.png"), {3, 2, 1, {-1.0, 2.0, std::nan(""), 127.5 / 255.0, 127.4 / 255.0, 1.0}});
	const auto Input = OIIO::ImageInput::open(Path("a.png"));
	std::vector<uint8_t> Bytes(6);
	ASSERT_TRUE(Input->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT8, Bytes.data()));
	EXPECT_EQ((std::vector<uint8_t>{0, 255, 0, 128, 127, 255}), Bytes);
}

TEST_F(ImageFile, PngIsDecodedToLinearWhenRead)
{
	WritePng(Path("a.png"), {1, 1, 3, {0.0, 188.0 / 255.0, 1.0}});
	const std::vector<std::vector<float>> Planes = FImageFile(Path("a.png")).Read({0, 1, 2});
	EXPECT_EQ(0.0f, Planes[0][0]);
	EXPECT_NEAR(0.502886, Planes[1][0], 1e-5); // ((188/255 + 0.055) / 1.055) ^ 2.4
	EXPECT_EQ(1.0f, Planes[2][0]);
}

TEST_F(ImageFile, SceneHasItsSeventeenChannels)
{
	const FImageFile File(Scenes + "toon_character_641x359.exr");
	EXPECT_EQ(641, File.GetWidth());
	EXPECT_EQ(359, File.GetHeight());
	EXPECT_EQ(17u, File.GetChannels().size());
	EXPECT_GE(File.FindChannel("shadingmodel.ID"), 0);
	EXPECT_EQ(-1, File.FindChannel("depth"));
}

TEST_F(ImageFile, SceneStatisticsAreThePublishedOnes)
{
	FImageFile File(Scenes + "toon_character_641x359.exr");
	const std::vector<float> Red = File.Read({File.FindChannel("R")})[0];
	double Sum = 0.0;
	for (const float Value : Red)
	{
		Sum += Value;
	}
	EXPECT_EQ(60.0f, *std::max_element(Red.begin(), Red.end()));
	EXPECT_NEAR(3.9529, Sum / static_cast<double>(Red.size()), 1e-4);
}

TEST_F(ImageFile, MissingFile)
{
	EXPECT_EQ((std::pair<int, int>{ErrorFileMissing, ExitFiles}), ErrorOf(Path("none.exr")));
	EXPECT_EQ((std::pair<int, int>{ErrorFileMissing, ExitFiles}), ErrorOf(Folder.string()));
}

TEST_F(ImageFile, FileThatIsNoImage)
{
	std::ofstream(Path("a.exr")) << "this is no picture";
	std::ofstream(Path("empty.exr")).close();
	EXPECT_EQ((std::pair<int, int>{ErrorImageBroken, ExitFiles}), ErrorOf(Path("a.exr")));
	EXPECT_EQ((std::pair<int, int>{ErrorImageBroken, ExitFiles}), ErrorOf(Path("empty.exr")));
}

TEST_F(ImageFile, TruncatedExrIsOneErrorWhereverItIsCut)
{
	const std::string Bytes = ReadBytes(Scenes + "toon_character_641x359.exr");
	for (const double Part : {0.0001, 0.01, 0.3, 0.5, 0.99})
	{
		std::ofstream(Path("cut.exr"), std::ios::binary)
			<< Bytes.substr(0, static_cast<size_t>(static_cast<double>(Bytes.size()) * Part));
		EXPECT_EQ((std::pair<int, int>{ErrorImageBroken, ExitFiles}), ErrorOf(Path("cut.exr"))) << Part;
	}
}

TEST_F(ImageFile, CorruptExrIsAnErrorOrReadsButNeverCrashes)
{
	const std::string Bytes = ReadBytes(Scenes + "toon_character_641x359.exr");
	for (size_t Offset = 4; Offset < 4000; Offset += 97)
	{
		std::string Damaged = Bytes;
		Damaged[Offset] = static_cast<char>(Damaged[Offset] ^ 0xFF);
		std::ofstream(Path("bad.exr"), std::ios::binary) << Damaged;
		const int ExitCode = ErrorOf(Path("bad.exr")).second;
		EXPECT_TRUE(ExitCode == 0 || ExitCode == ExitFiles) << Offset;
	}
}

TEST_F(ImageFile, ForgedHeadersAreRefusedForWhatTheySay)
{
	const std::string Corpus = DRYDOCK_TEST_SOURCE_DIR "/tests/fuzz/corpus/exr/forged_";
	const std::vector<std::pair<std::string, int>> Forged = {
		{"window", ErrorImageTooLarge}, // 16384 x 1048577
		{"window_negative", ErrorImageTooLarge},
		{"window_sparse", ErrorImageBroken}, // 16384 x 16384 by RLE in a kilobyte
		{"window_zip", ErrorImageBroken},
		{"attribute", ErrorImageBroken}, // 2 GB
		{"attribute_negative", ErrorImageBroken},
		{"tile_huge", ErrorImageBroken}, // 16000 x 16000
		{"tile_tiny", ErrorImageBroken}, // a million tiles
		{"tile_none", ErrorImageBroken},
		{"chunks", ErrorImageBroken}, // 2^31 of them
		{"sampling", ErrorImageBroken},
		{"channel_type", ErrorImageBroken},
		{"name", ErrorImageBroken},
		{"png", ErrorImageBroken},
	};
	std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins anew
	const int64_t Before = GetPeakKilobytes();
	for (const auto& [Name, Code] : Forged)
	{
		EXPECT_EQ((std::pair<int, int>{Code, ExitFiles}), ErrorOf(Corpus + Name + ".exr")) << Name;
	}
	EXPECT_LT(GetPeakKilobytes() - Before, 100'000); // of the gigabytes that they ask for
}

TEST_F(ImageFile, DiskThatIsFullIsAWriteError)
{
	// Large enough that no buffer keeps it all until the file is closed, and as small as a first picture.
	const FImage Noise{256, 256, 3, DrawNoise(size_t(256) * 256 * 3)};
	for (const FImage& Image : {Noise, TwoPixels})
	{
		for (const char* Name : {"full.png", "full.exr"})
		{
			std::filesystem::remove(Path(Name));
			std::filesystem::create_symlink("/dev/full", Path(Name));
			try
			{
				std::string(Name) == "full.png" ? WritePng(Path(Name), Image)
												: WriteExr(Path(Name), Image, {"R", "G", "B"});
				ADD_FAILURE() << Name << " " << Image.Width;
			}
			catch (const FError& Error)
			{
				EXPECT_EQ(ErrorFileNotWritten, Error.GetDiagnostics()[0].Code);
				EXPECT_EQ(Path(Name), Error.GetDiagnostics()[0].File);
				EXPECT_EQ(ExitFiles, Error.GetExitCode());
			}
		}
	}
}

TEST_F(ImageFile, FolderThatDoesNotExistIsAWriteError)
{
	try
	{
		WritePng(Path("none/a.png"), TwoPixels);
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ErrorFileNotWritten, Error.GetDiagnostics()[0].Code);
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
	}
}
