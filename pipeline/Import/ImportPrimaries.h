// Converts colours from the primaries of a file's "chromaticities" to those of a scene, Rec.709.
#pragma once

#include "DrydockAPI.h"
#include "Tonemap/ColorMatrix.h"

#include <optional>
#include <vector>

namespace Drydock
{

/** Chromaticities: x, y of red, green, blue and white. None where they are Rec.709's own, to a thousandth, are missing
 * or span no colours. White is adapted by the Bradford method. */
DRYDOCK_API std::optional<FColorMatrix> MakeRec709Matrix(const std::vector<float>& Chromaticities);

} // namespace Drydock
