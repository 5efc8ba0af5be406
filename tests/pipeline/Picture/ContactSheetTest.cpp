// Contact sheets: where tiles lie, how pictures are scaled, crops and insets, captions.
#include <gtest/gtest.h>

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "Picture/Srgb.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

FImage Plain(int Width, int Height, double Value)
{
	return {Width, Height, 3, std::vector<double>(static_cast<size_t>(Width) * static_cast<size_t>(Height) * 3, Value)};
}

FImage Row(const std::vector<double>& Values)
{
	FImage Image{static_cast<int>(Values.size()), 1, 3, {}};
	for (const double Value : Values)
	{
		Image.Values.insert(Image.Values.end(), 3, Value);
	}
	return Image;
}

std::vector<FSheetTile> Tiles(int Count, const std::string& Caption = "")
{
	return std::vector<FSheetTile>(static_cast<size_t>(Count), {Plain(64, 32, 1), Caption});
}

FSheetOptions Wide(int Width, int Columns = 0)
{
	FSheetOptions Options;
	Options.TileWidth = Width;
	Options.Columns = Columns;
	return Options;
}

constexpr int Gap = 8, Caption = 22; // the sheet's own

} // namespace

TEST(ContactSheet, TilesLieInRowsWithGapsAround)
{
	const FImage Sheet = MakeContactSheet(Tiles(5), Wide(64, 3));
	EXPECT_EQ(Gap + 3 * (64 + Gap), Sheet.Width);
	EXPECT_EQ(Gap + 2 * (32 + Gap), Sheet.Height);
	EXPECT_NEAR(1, Sheet.Get(Gap, Gap, 0), 1e-9);                       // first
	EXPECT_NEAR(1, Sheet.Get(Gap + 64 + Gap, Gap + 32 + Gap, 0), 1e-9); // fifth
	EXPECT_LT(Sheet.Get(Gap + 2 * (64 + Gap), Gap + 32 + Gap, 0), 0.2); // there is no sixth
	EXPECT_LT(Sheet.Get(Gap - 1, Gap, 0), 0.2);
}

TEST(ContactSheet, AsManyColumnsAsRows)
{
	EXPECT_EQ(Gap + 4 * (64 + Gap), MakeContactSheet(Tiles(16), Wide(64)).Width);
	EXPECT_EQ(Gap + 3 * (64 + Gap), MakeContactSheet(Tiles(5), Wide(64)).Width);
	EXPECT_EQ(Gap + 64 + Gap, MakeContactSheet(Tiles(1), Wide(64, 7)).Width);
}

TEST(ContactSheet, RowIsAsHighAsItsHighestTile)
{
	std::vector<FSheetTile> Mixed = Tiles(2);
	Mixed[1].Picture = Plain(64, 48, 1);
	EXPECT_EQ(Gap + 48 + Gap, MakeContactSheet(Mixed, Wide(64, 2)).Height);
}

TEST(ContactSheet, CaptionsTakeALineWhereThereAreAny)
{
	const FImage Sheet = MakeContactSheet(Tiles(1, "III"), Wide(64));
	EXPECT_EQ(Gap + 32 + Caption + Gap, Sheet.Height);
	double Brightest = 0;
	for (int X = Gap; X < Gap + 20; ++X)
	{
		Brightest = std::max(Brightest, Sheet.Get(X, Gap + 32 + 10, 0));
	}
	EXPECT_GT(Brightest, 0.7); // ink
	EXPECT_EQ(Gap + 32 + Gap, MakeContactSheet(Tiles(1), Wide(64)).Height);
}

TEST(ContactSheet, LongCaptionStaysInItsTile)
{
	const FImage Sheet = MakeContactSheet(Tiles(2, "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW"), Wide(64, 2));
	for (int Y = Gap + 32; Y < Gap + 32 + Caption; ++Y)
	{
		EXPECT_LT(Sheet.Get(Gap + 64 + Gap / 2, Y, 0), 0.2) << Y; // between the two
	}
}

TEST(ContactSheet, NoTilesGiveAnEmptySheet)
{
	EXPECT_EQ(Gap, MakeContactSheet({}, Wide(64)).Height);
}

TEST(ContactSheet, PicturesAreScaledByTheMeanOfTheirLight)
{
	// Black and white: half the light, which is encoded as 0.7354.
	const FImage Half = ScalePicture(Row({0, 1, 0, 1}), 2);
	EXPECT_EQ(2, Half.Width);
	EXPECT_EQ(1, Half.Height);
	EXPECT_NEAR(EncodeSrgb(0.5), Half.Get(0, 0, 0), 1e-9);
	EXPECT_NEAR(0.7354, Half.Get(1, 0, 2), 1e-4);
}

TEST(ContactSheet, ScalingByAFractionWeighsByTheArea)
{
	// Three texels to two pixels: the first covers all of the first and half of the second.
	const FImage Scaled = ScalePicture(Row({1, 0, 0}), 2);
	EXPECT_NEAR(2.0 / 3, DecodeSrgb(Scaled.Get(0, 0, 0)), 1e-9);
	EXPECT_NEAR(0, Scaled.Get(1, 0, 0), 1e-9);
}

TEST(ContactSheet, EnlargedTexelsStayHard)
{
	const FImage Scaled = ScalePicture(Row({0, 1}), 6);
	EXPECT_NEAR(0, Scaled.Get(2, 0, 0), 1e-9);
	EXPECT_NEAR(1, Scaled.Get(3, 0, 0), 1e-9);
}

TEST(ContactSheet, SameSizeKeepsTheValues)
{
	FImage Picture = Row({0, 0.2, 0.4, 0.6, 0.8, 1});
	const FImage Same = ScalePicture(Picture, 6);
	for (int X = 0; X < 6; ++X)
	{
		EXPECT_NEAR(Picture.Get(X, 0, 0), Same.Get(X, 0, 0), 1e-9) << X;
	}
}

TEST(ContactSheet, GreyAndAlphaBecomeThreeChannels)
{
	EXPECT_EQ(3, ScalePicture({2, 1, 1, {0.5, 0.5}}, 2).NumChannels);
	EXPECT_NEAR(0.25, ScalePicture({1, 1, 4, {0, 0.25, 1, 0.1}}, 1).Get(0, 0, 1), 1e-9);
}

TEST(ContactSheet, ValuesThatAreNoneCountAsBlack)
{
	EXPECT_NEAR(0, ScalePicture(Row({std::nan("")}), 1).Get(0, 0, 0), 1e-9);
	EXPECT_NEAR(1, ScalePicture(Row({HUGE_VAL}), 1).Get(0, 0, 0), 1e-9);
}

TEST(ContactSheet, CropTakesAPart)
{
	FSheetOptions Options = Wide(16);
	Options.Crop = FSheetRegion{2, 0, 1, 1};
	const FImage Sheet = MakeContactSheet({{Row({0, 0, 1, 0}), ""}}, Options);
	EXPECT_NEAR(1, Sheet.Get(Gap, Gap, 0), 1e-9);
	EXPECT_EQ(Gap + 16 + Gap, Sheet.Height);
}

TEST(ContactSheet, InsetIsEnlargedAndBrightenedBeneath)
{
	// Light of 0.1, four times: 0.4.
	FSheetOptions Options = Wide(80);
	Options.Inset = FSheetRegion{0, 0, 10, 10};
	Options.InsetGain = 4;
	const FImage Sheet = MakeContactSheet({{Plain(40, 20, EncodeSrgb(0.1)), ""}}, Options);
	EXPECT_EQ(Gap + 40 + Gap / 2 + 80 + Gap, Sheet.Height);
	EXPECT_NEAR(0.4, DecodeSrgb(Sheet.Get(Gap + 10, Gap + 40 + Gap / 2 + 10, 0)), 1e-9);
	EXPECT_NEAR(0.1, DecodeSrgb(Sheet.Get(Gap + 5, Gap + 5, 0)), 1e-9); // the picture itself
	EXPECT_GT(Sheet.Get(Gap, Gap + 5, 0), 0.9);                         // framed
}

TEST(ContactSheet, RegionsAreInsideOrNot)
{
	EXPECT_TRUE(IsInside({0, 0, 4, 3}, 4, 3));
	EXPECT_FALSE(IsInside({1, 0, 4, 3}, 4, 3));
	EXPECT_FALSE(IsInside({0, -1, 2, 2}, 4, 3));
	EXPECT_FALSE(IsInside({0, 0, 0, 3}, 4, 3));
	EXPECT_FALSE(IsInside({1 << 30, 0, 1 << 30, 1}, 4, 3));
}

TEST(PictureFile, EightBitPicturesComeBackAsTheyWere)
{
	const std::string Path =
		(std::filesystem::temp_directory_path() / ("drydock_picture_" + std::to_string(getpid()))).string() +
		"/made/picture.png";
	FImage Picture{256, 1, 3, {}};
	for (int Level = 0; Level < 256; ++Level)
	{
		Picture.Values.insert(Picture.Values.end(), {Level / 255.0, (255 - Level) / 255.0, 0.0});
	}
	WritePicture(Path, Picture);
	const FImage Read = ReadPicture(Path);
	EXPECT_EQ(Picture.Values, Read.Values);
	std::filesystem::remove_all(std::filesystem::path(Path).parent_path().parent_path());
}

TEST(PictureFile, LinearPicturesAreCutAndEncoded)
{
	const std::string Path =
		(std::filesystem::temp_directory_path() / ("drydock_picture_" + std::to_string(getpid()) + ".exr")).string();
	WriteExr(Path, {2, 1, 3, {0.5, 0.5, 0.5, 7, 7, 7}}, {"R", "G", "B"});
	const FImage Read = ReadPicture(Path);
	EXPECT_NEAR(EncodeSrgb(0.5), Read.Get(0, 0, 0), 1e-9);
	EXPECT_NEAR(1, Read.Get(1, 0, 2), 1e-6);
	std::filesystem::remove(Path);
}
