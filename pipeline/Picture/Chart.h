// A chart as data: panels with axes, lines, points and names. DrawChart makes a file of it, and the pages of
// `pipeline/Report` hold it as JSON and draw the same. Equal data give equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

/** Points in ascending x. */
using FChartCurve = std::vector<std::pair<double, double>>;

struct FChartTick
{
	double Value = 0.0;
	std::string Text;
};

struct DRYDOCK_API FChartAxis
{
	std::string Name;
	bool bLog = false;
	double Low = 0.0;
	double High = 1.0;
	std::vector<FChartTick> Ticks;
	std::vector<std::string> ValueNames; // of whole numbers from 0 on: an enum's

	/** 0 at Low, 1 at High. A logarithmic axis has what lies outside at its end. */
	double Map(double Value) const;
	/** A value's name; else four significant digits. */
	std::string NameValue(double Value) const;
};

/** Covers all of Values with room at the ends; those that are not above 0 do not count. Ticks are powers of ten, and
 * simple multiples of these where there are few. */
DRYDOCK_API FChartAxis MakeLogAxis(const std::string& Name, const std::vector<double>& Values);

/** Ticks are multiples of 1, 2 or 5 times a power of ten, at most MaxTicks steps from Low to High (above Low); where
 * whole numbers have names, they are at these alone. */
DRYDOCK_API FChartAxis MakeLinearAxis(
	const std::string& Name, double Low, double High, int MaxTicks, const std::vector<std::string>& ValueNames = {});

/** The text of a tick on a logarithmic axis: "0.01", "500", or ten to a power. */
DRYDOCK_API std::string NameLogTick(double Value);

struct FChartPoint
{
	double X = 0.0;
	double Y = 0.0;
	double Low = 0.0; // whiskers from Low to High, along x; none where both are the same
	double High = 0.0;
	std::string Label = {}; // beside it, where there is room
	std::string Tip = {};   // for a pointer that rests on it
	bool bPale = false;
	bool bNow = false;  // a dashed ring
	bool bPick = false; // a ring

	/** Labels of more important points get the room first. */
	int GetImportance() const { return (bPick ? 8 : 0) + (bNow ? 4 : 0) + (bPale ? 0 : 2); }
};

struct FChartSeries
{
	std::string Name;
	std::string Color; // a class of the style sheet: "c0" to "c9", "ink", "red", "green", "blue", "grey"
	FChartCurve Line;
	bool bSteps = false;  // nothing lies between two values
	bool bFilled = false; // down to the axis
	std::vector<FChartPoint> Points;
};

struct FChartPanel
{
	std::string Title;
	std::string Unit;
	std::string Aside; // at the right end of the title
	FChartAxis X;
	FChartAxis Y;
	std::optional<double> Limit; // of y: a line with its name; what is below is within
	std::vector<FChartSeries> Series;
	int NumColumns = 1;    // panels of this size beside one another
	double Height = 0.0;   // of the plot, pixels
	double NameRoom = 0.0; // to the right of the plot, for labels, pixels
	bool bShaded = false;  // the chart's shades are behind it
};

/** A curve of 0..1 as a colour behind panels. */
struct FChartShade
{
	std::string Name;
	std::string Color;
	FChartCurve Weights;
};

struct FChartLegend
{
	std::string Text;
	std::string Color; // of the point; "front": a line
	FChartPoint Look;
};

struct FChart
{
	std::string Title;
	std::vector<std::string> Notes;                // one line each, below the title
	std::vector<std::vector<FChartLegend>> Legend; // by row
	std::string MarkName;                          // what marks are: "frame"
	std::vector<FChartTick> Marks;                 // places on x that every panel shows
	std::vector<FChartShade> Shades;
	std::vector<FChartPanel> Panels;
	double AxisRoom = 62.0; // to the left of each plot, pixels
};

/** Draws the chart as SVG. It is legible on light and dark pages: it follows the reader's colour scheme. */
DRYDOCK_API std::string DrawChart(const FChart& Chart);

} // namespace Drydock
