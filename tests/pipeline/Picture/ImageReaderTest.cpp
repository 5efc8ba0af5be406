// What OpenEXR and libpng are asked for directly is what OpenImageIO gives: every shipped scene, and files drawn at
// random of every kind that the formats know.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Picture/ImagePlane.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <png.h>
#include <random>
#include <unistd.h>

using namespace Drydock;

namespace
{

const std::filesystem::path Configs = DRYDOCK_TEST_SOURCE_DIR "/configs";

/** A folder of this test, gone afterwards. */
class ImageReader : public testing::Test
{
protected:
	ImageReader()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_reader_" + std::to_string(getpid())))
	{
		std::filesystem::create_directories(Folder);
	}
	~ImageReader() override { std::filesystem::remove_all(Folder); }

	std::string Path(const std::string& Name) const { return (Folder / Name).string(); }

	const std::filesystem::path Folder;
};

bool IsSame(float One, float Other)
{
	return std::memcmp(&One, &Other, sizeof(float)) == 0 || (std::isnan(One) && std::isnan(Other));
}

/** All values of a part by OpenImageIO, channels interleaved. */
std::vector<float> ReadByOpenImageIO(OIIO::ImageInput& Input, int Part)
{
	EXPECT_TRUE(Input.seek_subimage(Part, 0));
	const OIIO::ImageSpec Spec = Input.spec();
	std::vector<float> Values(static_cast<size_t>(Spec.width * Spec.height * Spec.nchannels));
	EXPECT_TRUE(Input.read_image(Part, 0, 0, Spec.nchannels, OIIO::TypeDesc::FLOAT, Values.data())) << Input.geterror();
	return Values;
}

/** Sizes, windows, names and every value. */
void ExpectSameAsOpenImageIO(const std::string& Path)
{
	SCOPED_TRACE(Path);
	const std::unique_ptr<OIIO::ImageInput> Seen = OIIO::ImageInput::open(Path);
	ASSERT_NE(nullptr, Seen) << OIIO::geterror();
	FImageFile File(Path);
	for (size_t Part = 0; Part < File.GetParts().size(); ++Part)
	{
		SCOPED_TRACE(Part);
		const FImagePart& Ours = File.GetParts()[Part];
		const std::vector<float> Theirs = ReadByOpenImageIO(*Seen, static_cast<int>(Part));
		const OIIO::ImageSpec Spec = Seen->spec();
		ASSERT_EQ(std::make_pair(Spec.width, Spec.height), std::make_pair(Ours.Width, Ours.Height));
		EXPECT_EQ(
			(FImageWindow{Spec.x - Spec.full_x, Spec.y - Spec.full_y, Spec.full_width, Spec.full_height}), Ours.Window);
		EXPECT_EQ(Spec.get_string_attribute("oiio:ColorSpace") == "sRGB", Ours.bEncoded);
		ASSERT_EQ(static_cast<size_t>(Spec.nchannels), Ours.Channels.size());
		std::vector<int> All(Ours.Channels.size());
		std::iota(All.begin(), All.end(), 0);
		const std::vector<FImagePlane> Planes = File.ReadPart(static_cast<int>(Part), All);
		for (size_t Channel = 0; Channel < All.size(); ++Channel)
		{
			const auto Of = std::find(Spec.channelnames.begin(), Spec.channelnames.end(), Ours.Channels[Channel]);
			ASSERT_NE(Spec.channelnames.end(), Of) << Ours.Channels[Channel];
			const size_t Index = static_cast<size_t>(Of - Spec.channelnames.begin());
			size_t NumOther = 0;
			for (size_t Pixel = 0; Pixel * All.size() < Theirs.size(); ++Pixel)
			{
				NumOther += IsSame(Theirs[Pixel * All.size() + Index], Planes[Channel].Get(Pixel)) ? 0 : 1;
			}
			EXPECT_EQ(0u, NumOther) << Ours.Channels[Channel];
		}
	}
	EXPECT_FALSE(Seen->seek_subimage(static_cast<int>(File.GetParts().size()), 0));
}

/** One part with channels of drawn types, tiled or not, in a window of its own. */
OIIO::ImageSpec DrawSpec(std::mt19937& Random, bool bTiled)
{
	const auto Draw = [&Random](int From, int To)
	{
		return std::uniform_int_distribution<int>(From, To)(Random);
	};
	const std::vector<std::string> Names = {
		"R", "G", "B", "A", "Z", "depth.Z", "N.X", "N.Y", "N.Z", "id", "view.left.R", "view.left.B"};
	OIIO::ImageSpec Spec(Draw(1, 70), Draw(1, 70), Draw(1, static_cast<int>(Names.size())), OIIO::TypeDesc::FLOAT);
	Spec.channelnames.assign(Names.begin(), Names.begin() + Spec.nchannels);
	for (int Channel = 0; Channel < Spec.nchannels; ++Channel)
	{
		const OIIO::TypeDesc Types[] = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT32};
		Spec.channelformats.push_back(Types[Draw(0, 2)]);
	}
	Spec.x = Draw(-9, 9);
	Spec.y = Draw(-9, 9);
	Spec.full_x = Draw(-9, 9);
	Spec.full_y = Draw(-9, 9);
	Spec.full_width = Draw(1, 90);
	Spec.full_height = Draw(1, 90);
	if (bTiled)
	{
		Spec.tile_width = 16;
		Spec.tile_height = 16;
	}
	const char* const Compressions[] = {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "dwaa"};
	Spec.attribute("compression", Compressions[Draw(0, 7)]);
	return Spec;
}

/** Pixels as the channels' types want them, of bits drawn at random: NaN, infinities and denormals are among them. */
std::vector<unsigned char> DrawPixels(std::mt19937& Random, const OIIO::ImageSpec& Spec)
{
	std::vector<unsigned char> Bytes(Spec.image_bytes(true));
	std::generate(Bytes.begin(), Bytes.end(), [&Random] { return static_cast<unsigned char>(Random() & 0xFF); });
	return Bytes;
}

void WriteRandomPng(const std::string& Path, std::mt19937& Random, int ColorType, int Depth, bool bInterlaced)
{
	FILE* const File = std::fopen(Path.c_str(), "wb");
	ASSERT_NE(nullptr, File);
	png_structp Png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
	png_infop Info = png_create_info_struct(Png);
	png_init_io(Png, File);
	const int Width = 1 + static_cast<int>(Random() % 40);
	const int Height = 1 + static_cast<int>(Random() % 40);
	png_set_IHDR(Png, Info, static_cast<png_uint_32>(Width), static_cast<png_uint_32>(Height), Depth, ColorType,
		bInterlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	std::vector<png_color> Palette(size_t(1) << std::min(Depth, 8));
	std::vector<png_byte> Alphas(Palette.size() / 2);
	if (ColorType == PNG_COLOR_TYPE_PALETTE)
	{
		for (png_color& Color : Palette)
		{
			Color = {static_cast<png_byte>(Random()), static_cast<png_byte>(Random()), static_cast<png_byte>(Random())};
		}
		png_set_PLTE(Png, Info, Palette.data(), static_cast<int>(Palette.size()));
		std::generate(Alphas.begin(), Alphas.end(), [&Random] { return static_cast<png_byte>(Random()); });
		if (Random() % 2 == 0 && !Alphas.empty())
		{
			png_set_tRNS(Png, Info, Alphas.data(), static_cast<int>(Alphas.size()), nullptr);
		}
	}
	switch (Random() % 4)
	{
	case 0:
		png_set_sRGB(Png, Info, PNG_sRGB_INTENT_PERCEPTUAL);
		break;
	case 1:
		png_set_gAMA(Png, Info, 1.0);
		break;
	case 2:
		png_set_gAMA(Png, Info, 0.45455);
		break;
	default:
		break;
	}
	png_write_info(Png, Info);
	std::vector<std::vector<png_byte>> Rows(
		static_cast<size_t>(Height), std::vector<png_byte>(png_get_rowbytes(Png, Info)));
	std::vector<png_bytep> Pointers;
	for (std::vector<png_byte>& Row : Rows)
	{
		std::generate(Row.begin(), Row.end(), [&Random] { return static_cast<png_byte>(Random()); });
		Pointers.push_back(Row.data());
	}
	png_write_image(Png, Pointers.data());
	png_write_end(Png, Info);
	png_destroy_write_struct(&Png, &Info);
	std::fclose(File);
}

} // namespace

TEST_F(ImageReader, ShippedScenesAreWhatOpenImageIOReads)
{
	size_t NumScenes = 0;
	for (const auto& Entry : std::filesystem::recursive_directory_iterator(Configs))
	{
		const std::string Extension = Entry.path().extension().string();
		if (Extension == ".exr" || Extension == ".png")
		{
			ExpectSameAsOpenImageIO(Entry.path().string());
			++NumScenes;
		}
	}
	EXPECT_LT(5u, NumScenes);
}

TEST_F(ImageReader, OddExrFilesAreWhatOpenImageIOReads)
{
	std::mt19937 Random(181);
	for (int Round = 0; Round < 60; ++Round)
	{
		const int NumParts = Round % 3 == 0 ? 3 : 1;
		std::vector<OIIO::ImageSpec> Specs;
		for (int Part = 0; Part < NumParts; ++Part)
		{
			Specs.push_back(DrawSpec(Random, Round % 2 == 0));
			OIIO::ImageSpec& Spec = Specs.back();
			Spec.attribute("oiio:subimagename", "part" + std::to_string(Part));
			std::tie(Spec.full_x, Spec.full_y, Spec.full_width, Spec.full_height) = std::make_tuple(
				Specs[0].full_x, Specs[0].full_y, Specs[0].full_width, Specs[0].full_height); // one for all parts
		}
		const auto Output = OIIO::ImageOutput::create("odd.exr");
		ASSERT_TRUE(Output->open(Path("odd.exr"), NumParts, Specs.data())) << Output->geterror();
		for (int Part = 0; Part < NumParts; ++Part)
		{
			const OIIO::ImageSpec& Spec = Specs[static_cast<size_t>(Part)];
			ASSERT_TRUE(Part == 0 || Output->open(Path("odd.exr"), Spec, OIIO::ImageOutput::AppendSubimage));
			ASSERT_TRUE(Output->write_image(OIIO::TypeDesc::UNKNOWN, DrawPixels(Random, Spec).data()))
				<< Output->geterror();
		}
		ASSERT_TRUE(Output->close());
		ExpectSameAsOpenImageIO(Path("odd.exr"));
	}
}

TEST_F(ImageReader, OddPngFilesAreWhatOpenImageIOReads)
{
	const std::vector<std::pair<int, std::vector<int>>> Kinds = {{PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}},
		{PNG_COLOR_TYPE_RGB, {8, 16}}, {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}}, {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}},
		{PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}}};
	std::mt19937 Random(182);
	for (const auto& [ColorType, Depths] : Kinds)
	{
		for (const int Depth : Depths)
		{
			for (int Round = 0; Round < 8; ++Round)
			{
				WriteRandomPng(Path("odd.png"), Random, ColorType, Depth, Round % 2 == 1);
				SCOPED_TRACE("type " + std::to_string(ColorType) + ", " + std::to_string(Depth) + " bits");
				ExpectSameAsOpenImageIO(Path("odd.png"));
			}
		}
	}
}
