// `drydock sheet`. Source: drydock.
#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

FError MakeArgumentError(const std::string& Where, const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = ErrorBadArgument;
	Diagnostic.Where = Where;
	Diagnostic.Message = Message;
	return FError(Diagnostic, ExitUsage);
}

/** The numbers of "1,2,3"; throws unless there are that many. */
std::vector<double> ParseNumbers(
	const char* Option, const std::string& Text, size_t Least, size_t Most, const char* Expected)
{
	std::vector<double> Numbers;
	const char* Position = Text.data();
	const char* const End = Text.data() + Text.size();
	for (bool bMore = true; bMore;)
	{
		double Number = 0.0;
		const std::from_chars_result Result = std::from_chars(Position, End, Number);
		bMore = Result.ec == std::errc() && Result.ptr != End && *Result.ptr == ',';
		if (Result.ec != std::errc() || (Result.ptr != End && !bMore))
		{
			Numbers.clear();
			break;
		}
		Numbers.push_back(Number);
		Position = Result.ptr + 1;
	}
	if (Numbers.size() < Least || Numbers.size() > Most)
	{
		throw MakeArgumentError(Option, "\"" + Text + "\": expected " + Expected);
	}
	return Numbers;
}

FSheetRegion ToRegion(const std::vector<double>& Numbers)
{
	const auto ToInt = [](double Number)
	{
		constexpr double Largest = 1 << 30;
		return static_cast<int>(std::min(std::max(Number, -Largest), Largest));
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
		throw MakeArgumentError(Option, "the region leaves " + Picture.string() + ", which is " +
											std::to_string(Width) + " x " + std::to_string(Height) + " pixels there");
	}
}

} // namespace

int SheetVerb(const FSheetVerbOptions& Options)
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
			throw MakeArgumentError("--inset", "the gain is not above 0");
		}
	}
	if (Options.Captions.size() > Options.Pictures.size())
	{
		throw MakeArgumentError("--caption", "there are " + std::to_string(Options.Captions.size()) +
												 " captions and only " + std::to_string(Options.Pictures.size()) +
												 (Options.Pictures.size() == 1 ? " picture" : " pictures"));
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
	std::printf("%s: %zu %s, %d x %d pixels\n", Options.OutputFile.c_str(), Tiles.size(),
		Tiles.size() == 1 ? "picture" : "pictures", Picture.Width, Picture.Height);
	return ExitDone;
}

} // namespace Drydock
