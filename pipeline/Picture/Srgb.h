// The sRGB curve, between light and what a display is sent. Source: IEC 61966-2-1.
#pragma once

#include <cmath>

namespace Drydock
{

/** 0 and below stay as they are times 12.92; light above 1 goes on along the curve. */
inline double EncodeSrgb(double Linear)
{
	return Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1.0 / 2.4) - 0.055;
}

/** The inverse. */
inline double DecodeSrgb(double Encoded)
{
	return Encoded <= 0.04045 ? Encoded / 12.92 : std::pow((Encoded + 0.055) / 1.055, 2.4);
}

} // namespace Drydock
