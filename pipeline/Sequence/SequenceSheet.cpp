// Puts the frames of a sequence onto a contact sheet.
#include "Sequence/SequenceSheet.h"

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"

namespace Drydock
{

std::vector<size_t> ChooseSheetFrames(size_t NumFrames, size_t NumTiles)
{
	std::vector<size_t> Chosen;
	for (size_t Index = 0; Index < NumFrames && NumFrames <= NumTiles; ++Index)
	{
		Chosen.push_back(Index);
	}
	for (size_t Tile = 0; Tile < NumTiles && NumFrames > NumTiles; ++Tile)
	{
		Chosen.push_back(Tile * (NumFrames - 1) / (NumTiles - 1));
	}
	return Chosen;
}

void WriteSequenceSheet(
	const std::string& File, const std::vector<int>& Frames, const std::vector<std::string>& Pictures)
{
	constexpr size_t NumTiles = 48;
	FSheetOptions Options;
	std::vector<FSheetTile> Tiles;
	for (const size_t Index : ChooseSheetFrames(Pictures.size(), NumTiles))
	{
		Tiles.push_back(
			{ScalePicture(ReadPicture(Pictures[Index]), Options.TileWidth), "frame " + std::to_string(Frames[Index])});
	}
	WritePng(File, MakeContactSheet(Tiles, Options), EPngEffort::Small);
}

} // namespace Drydock
