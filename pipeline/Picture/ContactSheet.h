// Pictures side by side, each with a caption: one picture to look at many by. Pure: pictures in, a picture out, equal
// input gives equal bits.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageFile.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A part of a picture, in its pixels. */
struct FSheetRegion
{
	int X = 0;
	int Y = 0;
	int Width = 0;
	int Height = 0;
};

struct FSheetTile
{
	/** Display-encoded (sRGB), of any size; the first three channels count, of one or two the first, as grey. */
	FImage Picture;
	/** One line; cut where the tile ends. Empty: none. */
	std::string Caption;
};

struct FSheetOptions
{
	/** 0: as many as rows, or one more. */
	int Columns = 0;
	/** Pictures are scaled to this width, in pixels, by the mean of the light; enlarged ones keep hard texels. */
	int TileWidth = 320;
	/** Only this part of each picture; it must lie inside the pictures. */
	std::optional<FSheetRegion> Crop;
	/** This part once more, enlarged beneath the picture and framed in it; it must lie inside what Crop leaves, in
	 * whose pixels it counts. */
	std::optional<FSheetRegion> Inset;
	/** Factor of the light in the inset, above 0. */
	double InsetGain = 1.0;
};

/** Row by row from the top left; a row is as high as its highest tile. Every picture holds a pixel at least. Three
 * channels; without tiles an edge of background only. */
DRYDOCK_API FImage MakeContactSheet(const std::vector<FSheetTile>& Tiles, const FSheetOptions& Options);

/** Whether a region holds a pixel and lies inside a picture of that size. */
DRYDOCK_API bool IsInside(const FSheetRegion& Region, int Width, int Height);

/** A display-encoded picture scaled to a width, by the mean of its light over each new pixel; the height follows, one
 * pixel at least. Three channels. */
DRYDOCK_API FImage ScalePicture(const FImage& Picture, int Width);

} // namespace Drydock
