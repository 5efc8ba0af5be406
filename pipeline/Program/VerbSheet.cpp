// `drydock sheet`: puts pictures side by side into one, each with a caption.
#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "Program/NumberList.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"

#include "Math/ToInteger.h"
#include "PrintText.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

struct FSheetVerbOptions
{
	std::vector<std::string> Pictures; // files, or folders of runs
	std::string OutputFile;
	std::vector<std::string> Captions; // of the first pictures, in place of their names
	int Columns = 0;                   // 0: chosen
	int TileWidth = 320;
	std::string Crop;  // "X,Y,WIDTH,HEIGHT"; empty: all
	std::string Inset; // "X,Y,WIDTH,HEIGHT[,GAIN]"; empty: none
};

FError MakeArgumentError(const std::string& Where, const std::string& Message)
{
	return FError({.Code = ErrorBadArgument, .Message = Message, .Where = Where}, ExitUsage);
}

FSheetRegion ToRegion(const std::vector<double>& Numbers)
{
	const auto ToInt = [](double Number)
	{
		constexpr int Largest = 1 << 30;
		return std::clamp(ToInteger<int>(Number), -Largest, Largest);
	};
	return {ToInt(Numbers[0]), ToInt(Numbers[1]), ToInt(Numbers[2]), ToInt(Numbers[3])};
}

/** A run's folder stands for its picture. */
Files::path ResolvePicture(const std::string& Argument)
{
	return Files::is_directory(Argument) ? Files::path(Argument) / "final.png" : Files::path(Argument);
}

/** "toon_bloom" of out/toon_bloom/final.png, else the name of the file. */
std::string MakeCaption(const Files::path& Picture)
{
	const Files::path Folder = Files::absolute(Picture).lexically_normal().parent_path();
	return Picture.filename() == "final.png" ? Folder.filename().string() : Picture.stem().string();
}

void CheckRegion(
	const char* Option, const std::optional<FSheetRegion>& Region, const Files::path& Picture, int Width, int Height)
{
	if (Region && !IsInside(*Region, Width, Height))
	{
		throw MakeArgumentError(Option,
			fmt::format("the region leaves {}, which is {} x {} pixels there", Picture.string(), Width, Height));
	}
}

int MakeSheet(const FSheetVerbOptions& Options)
{
	if (Files::path(Options.OutputFile).extension() != ".png")
	{
		throw MakeArgumentError("--out", "\"" + Options.OutputFile + "\": expected a file that ends in .png");
	}
	FSheetOptions Sheet;
	Sheet.Columns = Options.Columns;
	Sheet.TileWidth = Options.TileWidth;
	if (!Options.Crop.empty())
	{
		Sheet.Crop = ToRegion(ParseNumbers("--crop", Options.Crop, 4, 4, "X,Y,WIDTH,HEIGHT in pixels"));
	}
	if (!Options.Inset.empty())
	{
		const std::vector<double> Numbers =
			ParseNumbers("--inset", Options.Inset, 4, 5, "X,Y,WIDTH,HEIGHT in pixels, and a gain above 0 behind them");
		Sheet.Inset = ToRegion(Numbers);
		Sheet.InsetGain = Numbers.size() == 5 ? Numbers[4] : 1.0;
		if (!(Sheet.InsetGain > 0.0))
		{
			throw MakeArgumentError("--inset", "the gain must be above 0");
		}
	}
	if (Options.Captions.size() > Options.Pictures.size())
	{
		throw MakeArgumentError(
			"--caption", fmt::format("there are {} captions and only {} {}", Options.Captions.size(),
							 Options.Pictures.size(), Options.Pictures.size() == 1 ? "picture" : "pictures"));
	}

	std::vector<FSheetTile> Tiles;
	for (const std::string& Argument : Options.Pictures)
	{
		const Files::path Path = ResolvePicture(Argument);
		FSheetTile Tile{ReadPicture(Path.string()), MakeCaption(Path)};
		if (Tiles.size() < Options.Captions.size())
		{
			Tile.Caption = Options.Captions[Tiles.size()];
		}
		CheckRegion("--crop", Sheet.Crop, Path, Tile.Picture.Width, Tile.Picture.Height);
		const FSheetRegion Whole = Sheet.Crop.value_or(FSheetRegion{0, 0, Tile.Picture.Width, Tile.Picture.Height});
		CheckRegion("--inset", Sheet.Inset, Path, Whole.Width, Whole.Height);
		Tiles.push_back(std::move(Tile));
	}
	const FImage Picture = MakeContactSheet(Tiles, Sheet);
	WritePicture(Options.OutputFile, Picture);
	PrintText(stdout, fmt::format("{}: {} {}, {} x {} pixels\n", Options.OutputFile, Tiles.size(),
						  Tiles.size() == 1 ? "picture" : "pictures", Picture.Width, Picture.Height));
	return ExitDone;
}

} // namespace

FVerbCall AddSheetOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSheetVerbOptions>();
	Verb.Add("PICTURE", Options->Pictures, "Pictures, or folders of runs; a folder stands for its final.png").Require();
	Verb.Add("--out", Options->OutputFile, "Picture to write").SetType("FILE.png").Require();
	Verb.Add("--columns", Options->Columns, "Number of pictures in a row; by default as many as rows")
		.RequireRange(1, 100)
		.SetType("N");
	Verb.Add("--width", Options->TileWidth, "Width of each picture in pixels; 320 by default")
		.RequireRange(16, 4096)
		.SetType("N");
	Verb.AddRepeated("--caption", "TEXT", Options->Captions,
		"Caption of the first picture, then of the second, and so on; repeats; the name of the file or folder by "
		"default");
	Verb.Add("--crop", Options->Crop, "Show only this part of each picture").SetType("X,Y,WIDTH,HEIGHT");
	Verb.Add("--inset", Options->Inset, "Show this part again below, enlarged, its light times GAIN")
		.SetType("X,Y,WIDTH,HEIGHT[,GAIN]");
	return CallWith(Options, MakeSheet);
}

} // namespace Drydock
