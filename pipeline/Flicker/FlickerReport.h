// Shows the figures of flicker: a table, JSON, a chart over the frames, and pictures of where.
#pragma once

#include "Flicker/FlickerRun.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Width: of the terminal; 0: as wide as the cells are. */
DRYDOCK_API std::string MakeFlickerTable(const FFlickerResult& Result, int Width);

/** The same bytes for the same result. */
DRYDOCK_API std::string MakeFlickerJson(const FFlickerResult& Result);

/** A panel for each picture: the jump of its light over the frames, a line for each variant. */
DRYDOCK_API std::string MakeFlickerChart(const FFlickerResult& Result, const std::string& Title);

/** Writes where.NAME.png and, of further variants, where.NAME.2.png into Folder: the worst of each pixel, by one scale
 * for all variants. Gives the names. Throws FError (exit code 3) when a file cannot be written. */
DRYDOCK_API std::vector<std::string> WriteFlickerPictures(const FFlickerResult& Result, const std::string& Folder);

} // namespace Drydock
