// A walk as a picture: settings along a path, one small chart each, over shades of the volumes that act. Pure, from
// plain data to SVG; equal data give equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

struct FSettingsWalk;

/** Distance along the path, cm, and a value there; in ascending distance. */
using FWalkCurve = std::vector<std::pair<double, double>>;

struct FWalkChartVolume
{
	std::string Name;
	bool bUnbound = false; // acts everywhere: a lane, but no shade
	FWalkCurve Weights;    // 0..1
};

struct FWalkChartLine
{
	std::string Label; // of a component: "R"; else empty
	FWalkCurve Values;
};

struct FWalkChartRow
{
	std::string Name;
	std::string Unit;
	bool bSteps = false;                 // no values between two values
	std::vector<std::string> ValueNames; // by whole number, of enums
	std::vector<FWalkChartLine> Lines;
};

/** A point of the path. */
struct FWalkChartMark
{
	double Distance = 0.0;
	std::string Label;
};

struct FWalkChart
{
	std::string Title;
	std::string Subtitle;
	std::string MarkName; // what the marks' labels are: "frame"
	double Length = 0.0;  // cm
	std::vector<FWalkChartMark> Marks;
	std::vector<FWalkChartVolume> Volumes;
	std::vector<FWalkChartRow> Rows;
};

/** The settings of a walk that can be drawn: all but objects and arrays. */
DRYDOCK_API FWalkChart MakeWalkChart(const FSettingsWalk& Walk, const std::string& Title, const std::string& MarkName);

/** Legible on light and dark pages: it follows the reader's colour scheme. */
DRYDOCK_API std::string DrawWalkChart(const FWalkChart& Chart);

} // namespace Drydock
