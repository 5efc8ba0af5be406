// The figure that docs/stability.md begins with.
#pragma once

namespace Stability
{

/** Share of the final picture of toon_character.exr at default settings that one pixel of +Inf, at InfinitePixel, turns
 * white, and that the same pixel loaded as 0 does (r.Drydock.NonFinite 1). */
constexpr double ShareTurnedWhite = 0.92;
constexpr int InfinitePixelX = 480;
constexpr int InfinitePixelY = 270;

} // namespace Stability
