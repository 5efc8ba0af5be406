// What a report shows of a pass beside its counters: the constants of its parameters, and a small picture of what it
// wrote.
#pragma once

#include "Run/RunResult.h"

class FRDGPass;
class FRHITexture;

namespace Drydock
{

/** The constants of the pass's own parameter struct, in its order, those of uniform buffers not among them; none of a
 * pass without one. Of an array at most the first 16 elements. */
std::vector<FRunParameter> ReadPassParameters(const FRDGPass& Pass);

/** Largest width and height of a thumbnail, pixels. */
constexpr int ThumbnailWidth = 192;
constexpr int ThumbnailHeight = 108;

/** Mip 0 of what passes have drawn, scaled down: each pixel is the mean of one row of the texels that it covers, the
 * middle one. Linear; where one of them is not finite, the pixel is NaN. */
FRunThumbnail MakeThumbnail(const std::string& Resource, FRHITexture& Texture, FIntRect Window);

} // namespace Drydock
