// Makes the small picture that a report shows of a pass's result, beside its counters.
#pragma once

#include "Run/RunResult.h"

class FRHITexture;

namespace Drydock
{

/** Largest width and height of a thumbnail, pixels. */
constexpr int ThumbnailWidth = 192;
constexpr int ThumbnailHeight = 108;

/** Mip 0 of what passes have drawn, scaled down: each pixel is the mean of one row of the texels that it covers, the
 * middle one. Linear; where one of them is not finite, the pixel is NaN. */
FRunThumbnail MakeThumbnail(const std::string& Resource, FRHITexture& Texture, FIntRect Window);

} // namespace Drydock
