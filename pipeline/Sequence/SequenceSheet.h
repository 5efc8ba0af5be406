// A contact sheet of a sequence: its frames side by side.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Drydock
{

/** Chooses those of NumFrames frames that a sheet of at most NumTiles shows: all, or the first, the last and the others
 * evenly between. Indices, ascending. NumTiles: 2 at least. */
DRYDOCK_API std::vector<size_t> ChooseSheetFrames(size_t NumFrames, size_t NumTiles);

/** Pictures: files, one to a frame. Reads one after another, scaled as it is read. File: a PNG that is not in its place
 * yet. Throws FError (exit code 3) when a picture cannot be read or the sheet cannot be written. */
DRYDOCK_API void WriteSequenceSheet(
	const std::string& File, const std::vector<int>& Frames, const std::vector<std::string>& Pictures);

} // namespace Drydock
