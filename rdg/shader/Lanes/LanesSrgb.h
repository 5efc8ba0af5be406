// Tables of 8-bit sRGB for lanes: the bits of EncodeSrgb8 and DecodeSrgb8.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>

namespace Drydock
{

/** The float of each of the 256 codes. */
DRYDOCK_API const float* GetSrgb8Decodes();

/** An entry for each value that the upper 16 bits of a float from 2^-13 to 1 have, the first of GSrgb8FirstBits. It
 * holds the code of the smallest such float, shifted left by 20, plus the lower 16 bits from which on the code is one
 * more, 0x10000 if none: no entry has two such places. Floats below have code 0. */
DRYDOCK_API const uint32_t* GetSrgb8Encodes();
constexpr int32_t GSrgb8FirstBits = 0x39000000;

} // namespace Drydock
