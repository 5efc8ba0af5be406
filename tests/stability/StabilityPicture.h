// The picture that docs/stability.md opens with: the table, a coloured square for each cell.
#pragma once

#include <string>

namespace Stability
{

/** SVG. Rows: the frame, then passes; columns: hazards. */
std::string MakeStabilityPicture();

} // namespace Stability
