// What a drawing needs beside lines: numbers as text, names that fit, ticks of an axis, curves of few points. Equal
// arguments give equal bytes. Source: drydock.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

using FSvgPoint = std::pair<double, double>;

/** At most that many digits after the point, without zeros at the end. */
DRYDOCK_API std::string FixedText(double Number, int Digits);

/** A coordinate: two digits after the point. */
DRYDOCK_API std::string Px(double Number);

/** Four significant digits. */
DRYDOCK_API std::string ShortText(double Number);

/** For text and attributes; control characters become blanks. */
DRYDOCK_API std::string EscapeXml(const std::string& Text);

/** A longer name ends in an ellipsis. UTF-8 stays whole. */
DRYDOCK_API std::string ShortenText(const std::string& Text, size_t MaxCharacters);

/** Where ticks stand: multiples of 1, 2 or 5 times a power of ten, at most MaxTicks steps from Low to High (above Low).
 */
struct DRYDOCK_API FAxisTicks
{
	FAxisTicks(double Low, double High, int MaxTicks);

	double Step = 1.0;
	int Digits = 0; // after the point
	std::vector<double> Values;
};

/** Without the points that lie on the line between those that stay, to a fiftieth of a pixel. */
DRYDOCK_API std::vector<FSvgPoint> SimplifyCurve(const std::vector<FSvgPoint>& Points);

} // namespace Drydock
