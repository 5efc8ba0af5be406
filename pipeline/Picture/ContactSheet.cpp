// Scales pictures to tiles, lays them out in rows and writes their captions.
#include "Picture/ContactSheet.h"

#include "Math/ToInteger.h"
#include "Picture/Srgb.h"
#include "Picture/StrokeText.h"
#include "RangeTools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr int Gap = 8; // around and between tiles
constexpr int CaptionHeight = 22;
constexpr double CapHeight = 9.0;
constexpr double CaptionBaseline = 15.0;
constexpr FTextColor Background = {0.11, 0.12, 0.13};
constexpr FTextColor Ink = {0.88, 0.89, 0.9};
constexpr FTextColor Frame = {1.0, 0.72, 0.2};

/** Pixels of the source that a new pixel covers, and how much of each. */
struct FSpan
{
	int Begin = 0;
	std::vector<double> Weights; // their sum is 1
};

std::vector<FSpan> MakeSpans(int SourceSize, int TargetSize)
{
	std::vector<FSpan> Spans;
	const double Scale = static_cast<double>(SourceSize) / TargetSize;
	for (int Target = 0; Target < TargetSize; ++Target)
	{
		const double From = Target * Scale;
		const double To = std::min((Target + 1) * Scale, static_cast<double>(SourceSize));
		FSpan Span{static_cast<int>(From), {}};
		for (int Source = Span.Begin; Source < SourceSize && Source < To; ++Source)
		{
			Span.Weights.push_back((std::min(Source + 1.0, To) - std::max<double>(Source, From)) / (To - From));
		}
		Spans.push_back(std::move(Span));
	}
	return Spans;
}

/** Values of 8-bit pictures, which are all but a few, from a table. */
double DecodeLight(double Encoded)
{
	static const std::array<double, 256> Table = []
	{
		std::array<double, 256> Values{};
		for (size_t Index = 0; Index < Values.size(); ++Index)
		{
			Values[Index] = DecodeSrgb(static_cast<double>(Index) / 255.0);
		}
		return Values;
	}();
	if (!(Encoded > 0.0))
	{
		return 0.0;
	}
	const double Clamped = std::min(Encoded, 1.0);
	const double Level = Clamped * 255.0;
	const double Nearest = std::round(Level);
	return std::abs(Level - Nearest) < 1e-6 ? Table[static_cast<size_t>(ToIndex(Nearest, 256))] : DecodeSrgb(Clamped);
}

FImage MakePlain(int Width, int Height, const FTextColor& Color)
{
	FImage Image{Width, Height, 3, {}};
	Image.Values.resize(static_cast<size_t>(Width) * static_cast<size_t>(Height) * 3);
	for (size_t Index = 0; Index < Image.Values.size(); ++Index)
	{
		Image.Values[Index] = Color[Index % 3];
	}
	return Image;
}

/** Three channels of light. */
FImage ToLight(const FImage& Picture)
{
	FImage Light{Picture.Width, Picture.Height, 3, {}};
	Light.Values.reserve(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.Height) * 3);
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		for (int X = 0; X < Picture.Width; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				Light.Values.push_back(DecodeLight(Picture.Get(X, Y, Picture.NumChannels >= 3 ? Channel : 0)));
			}
		}
	}
	return Light;
}

FImage CropPicture(const FImage& Picture, const FSheetRegion& Region)
{
	FImage Crop{Region.Width, Region.Height, Picture.NumChannels, {}};
	for (int Y = Region.Y; Y < Region.Y + Region.Height; ++Y)
	{
		for (int X = Region.X; X < Region.X + Region.Width; ++X)
		{
			for (int Channel = 0; Channel < Picture.NumChannels; ++Channel)
			{
				Crop.Values.push_back(Picture.Get(X, Y, Channel));
			}
		}
	}
	return Crop;
}

FImage Brighten(const FImage& Picture, double Gain)
{
	FImage Bright = ToLight(Picture);
	for (double& Value : Bright.Values)
	{
		Value = EncodeSrgb(std::min(Value * Gain, 1.0));
	}
	return Bright;
}

void Paste(const FImage& Source, int Left, int Top, FImage& Target)
{
	for (int Y = 0; Y < Source.Height; ++Y)
	{
		const size_t From = static_cast<size_t>(Y) * static_cast<size_t>(Source.Width) * 3;
		const size_t To =
			(static_cast<size_t>(Top + Y) * static_cast<size_t>(Target.Width) + static_cast<size_t>(Left)) * 3;
		std::copy_n(Source.Values.begin() + static_cast<std::ptrdiff_t>(From), Source.Width * 3,
			Target.Values.begin() + static_cast<std::ptrdiff_t>(To));
	}
}

/** A line of one pixel, inside the picture. */
void DrawFrame(FImage& Picture, int Left, int Top, int Right, int Bottom)
{
	for (int Y = std::max(0, Top); Y <= std::min(Picture.Height - 1, Bottom); ++Y)
	{
		for (int X = std::max(0, Left); X <= std::min(Picture.Width - 1, Right); ++X)
		{
			if (X == Left || X == Right || Y == Top || Y == Bottom)
			{
				Paste(MakePlain(1, 1, Frame), X, Y, Picture);
			}
		}
	}
}

std::string GetGainText(double Gain)
{
	const double Rounded = std::round(Gain * 10.0) / 10.0;
	std::string Text = std::to_string(ToInteger<long>(Rounded));
	const long Tenths = ToInteger<long>(std::round((Rounded - std::floor(Rounded)) * 10.0));
	return "x " + Text + (Tenths > 0 ? "." + std::to_string(Tenths) : "");
}

/** The enlarged region, with what its light is multiplied by written into a corner. */
FImage MakeInset(const FImage& Picture, const FSheetOptions& Options)
{
	FImage Inset = ScalePicture(Brighten(CropPicture(Picture, *Options.Inset), Options.InsetGain), Options.TileWidth);
	DrawFrame(Inset, 0, 0, Inset.Width - 1, Inset.Height - 1);
	const std::string Text = GetGainText(Options.InsetGain);
	const double TextWidth = GetStrokeTextWidth(Text, CapHeight);
	const int BoxWidth = ToInteger<int>(TextWidth) + 13, BoxHeight = 20;
	if (Options.InsetGain != 1.0 && Inset.Width > BoxWidth && Inset.Height > BoxHeight)
	{
		Paste(MakePlain(BoxWidth, BoxHeight, Background), Inset.Width - BoxWidth, Inset.Height - BoxHeight, Inset);
		DrawStrokeText(Inset, Inset.Width - BoxWidth + 6, Inset.Height - 5.5, Text, CapHeight, Frame);
	}
	return Inset;
}

/** The picture, and what is beneath it but the caption. */
FImage MakeBody(const FImage& Picture, const FSheetOptions& Options)
{
	const FImage Cropped = Options.Crop ? CropPicture(Picture, *Options.Crop) : Picture;
	FImage Body = ScalePicture(Cropped, Options.TileWidth);
	if (!Options.Inset)
	{
		return Body;
	}
	const double Scale = static_cast<double>(Body.Width) / Cropped.Width;
	const FSheetRegion& Region = *Options.Inset;
	DrawFrame(Body, ToInteger<int>(Region.X * Scale), ToInteger<int>(Region.Y * Scale),
		ToInteger<int>(std::ceil((Region.X + Region.Width) * Scale)) - 1,
		ToInteger<int>(std::ceil((Region.Y + Region.Height) * Scale)) - 1);
	const FImage Inset = MakeInset(Cropped, Options);
	FImage Both = MakePlain(Options.TileWidth, Body.Height + Gap / 2 + Inset.Height, Background);
	Paste(Body, 0, 0, Both);
	Paste(Inset, 0, Body.Height + Gap / 2, Both);
	return Both;
}

/** A sheet is rather wide than high: pictures are, too. */
int ChooseColumns(size_t NumTiles)
{
	return std::max(1, ToInteger<int>(std::ceil(std::sqrt(static_cast<double>(NumTiles)))));
}

} // namespace

bool IsInside(const FSheetRegion& Region, int Width, int Height)
{
	return Region.X >= 0 && Region.Y >= 0 && Region.Width > 0 && Region.Height > 0 &&
		   Region.X <= Width - Region.Width && Region.Y <= Height - Region.Height;
}

FImage ScalePicture(const FImage& Picture, int Width)
{
	const int Height =
		std::max(1, ToInteger<int>(std::round(static_cast<double>(Picture.Height) * Width / Picture.Width)));
	const FImage Light = ToLight(Picture);
	const std::vector<FSpan> Columns = MakeSpans(Picture.Width, Width);
	const std::vector<FSpan> Rows = MakeSpans(Picture.Height, Height);
	FImage Scaled{Width, Height, 3, {}};
	Scaled.Values.reserve(static_cast<size_t>(Width) * static_cast<size_t>(Height) * 3);
	for (const FSpan& Row : Rows)
	{
		for (const FSpan& Column : Columns)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				double Sum = 0.0;
				for (size_t Y = 0; Y < Row.Weights.size(); ++Y)
				{
					for (size_t X = 0; X < Column.Weights.size(); ++X)
					{
						Sum += Row.Weights[Y] * Column.Weights[X] *
							   Light.Get(Column.Begin + static_cast<int>(X), Row.Begin + static_cast<int>(Y), Channel);
					}
				}
				Scaled.Values.push_back(EncodeSrgb(Sum));
			}
		}
	}
	return Scaled;
}

FImage MakeContactSheet(const std::vector<FSheetTile>& Tiles, const FSheetOptions& Options)
{
	auto Bodies = ToVector<FImage>(Tiles, [&](const FSheetTile& Tile) { return MakeBody(Tile.Picture, Options); });
	const int NumTiles = static_cast<int>(Tiles.size());
	const int NumColumns =
		std::min(std::max(1, NumTiles), Options.Columns > 0 ? Options.Columns : ChooseColumns(Tiles.size()));
	const bool bCaptions = std::ranges::any_of(Tiles, [](const FSheetTile& Tile) { return !Tile.Caption.empty(); });

	std::vector<int> Tops = {Gap};
	for (int First = 0; First < NumTiles; First += NumColumns)
	{
		int Height = 0;
		for (int Index = First; Index < std::min(NumTiles, First + NumColumns); ++Index)
		{
			Height = std::max(Height, Bodies[static_cast<size_t>(Index)].Height);
		}
		Tops.push_back(Tops.back() + Height + (bCaptions ? CaptionHeight : 0) + Gap);
	}
	FImage Sheet = MakePlain(Gap + NumColumns * (Options.TileWidth + Gap), Tops.back(), Background);
	for (int Index = 0; Index < NumTiles; ++Index)
	{
		const FImage& Body = Bodies[static_cast<size_t>(Index)];
		const int Left = Gap + Index % NumColumns * (Options.TileWidth + Gap);
		const int Top = Tops[static_cast<size_t>(Index / NumColumns)];
		Paste(Body, Left, Top, Sheet);
		DrawStrokeText(Sheet, Left + 1, Top + Body.Height + CaptionBaseline,
			FitStrokeText(Tiles[static_cast<size_t>(Index)].Caption, CapHeight, Options.TileWidth - 2), CapHeight, Ink);
	}
	return Sheet;
}

} // namespace Drydock
