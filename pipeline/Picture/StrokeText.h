// Text in pictures, drawn with strokes of a font that is built in: the same pixels on every machine, at any size.
// Printable ASCII; of anything else each byte sequence of UTF-8 is one question mark.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageFile.h"

#include <array>
#include <string>

namespace Drydock
{

/** Display-encoded red, green and blue, 0..1. */
using FTextColor = std::array<double, 3>;

/** Width from the left edge of the first letter to the right edge of the last, in pixels. CapHeight: of a capital
 * letter. */
DRYDOCK_API double GetStrokeTextWidth(const std::string& Text, double CapHeight);

/** Draws over a picture of three channels. X: left edge of the first letter; Baseline: where letters stand, downwards
 * from the top; both in pixels. Parts outside the picture are left out. Legible from a CapHeight of 7 on. */
DRYDOCK_API void DrawStrokeText(
	FImage& Picture, double X, double Baseline, const std::string& Text, double CapHeight, const FTextColor& Color);

/** Text that is too wide ends in three dots; empty where not even these fit. */
DRYDOCK_API std::string FitStrokeText(const std::string& Text, double CapHeight, double Width);

} // namespace Drydock
