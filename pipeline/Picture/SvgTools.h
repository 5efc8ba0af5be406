// Parts of SVG drawings: the page with its style sheet, text, lines and paths, numbers as text, names that fit. Equal
// arguments give equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

// Pixels.
constexpr double SvgPageWidth = 1120.0;
constexpr double SvgPageMargin = 24.0;

using FSvgPoint = std::pair<double, double>;

/** Pixels. */
struct FSvgBox
{
	double Left = 0.0;
	double Top = 0.0;
	double Right = 0.0;
	double Bottom = 0.0;

	bool Overlaps(const FSvgBox& Other) const
	{
		return Left < Other.Right && Other.Left < Right && Top < Other.Bottom && Other.Top < Bottom;
	}
	bool Contains(const FSvgBox& Other) const
	{
		return Other.Left >= Left && Other.Right <= Right && Other.Top >= Top && Other.Bottom <= Bottom;
	}
};

/** At most that many digits after the point, without zeros at the end. */
DRYDOCK_API std::string FixedText(double Number, int Digits);

/** A coordinate: two digits after the point. */
DRYDOCK_API std::string Px(double Number);

/** Four significant digits. */
DRYDOCK_API std::string ShortText(double Number);

/** Escapes text for elements and attributes; control characters become blanks. */
DRYDOCK_API std::string EscapeXml(const std::string& Text);

/** A longer name ends in an ellipsis. UTF-8 stays whole. */
DRYDOCK_API std::string ShortenText(const std::string& Text, size_t MaxCharacters);

/** Text whose base line begins at X, Y, or is aligned there by its class. Class: empty for none. */
DRYDOCK_API std::string SvgText(double X, double Y, const std::string& Class, const std::string& Text);

/** The same with markup inside, such as <tspan>. */
DRYDOCK_API std::string SvgMarkup(double X, double Y, const std::string& Class, const std::string& Markup);

DRYDOCK_API std::string SvgLine(double X1, double Y1, double X2, double Y2, const std::string& Class);

DRYDOCK_API std::string SvgRect(const FSvgBox& Box, const std::string& Class);

/** "M1 2 L3 4": the points as the data of a path. */
DRYDOCK_API std::string SvgPathData(const std::vector<FSvgPoint>& Points);

/** An open line through the points. */
DRYDOCK_API std::string SvgPath(const std::vector<FSvgPoint>& Points, const std::string& Class);

/** Opens a drawing of that height, in pixels, with page and style sheet. It has a light and a dark side; the reader's
 * colour scheme chooses. Title: for readers who cannot see the drawing. */
DRYDOCK_API std::string BeginSvg(double Height, const std::string& Title);

} // namespace Drydock
