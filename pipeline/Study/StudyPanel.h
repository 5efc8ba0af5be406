// One pair of logarithmic axes in a drawing, and labels that keep out of each other's way. Inner to StudyChart.
#pragma once

#include "Picture/SvgTools.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** Maps numbers above 0 to pixels, in equal steps for equal factors. */
class FLogAxis
{
public:
	/** Covers all of Values with room at the ends; those that are not above 0 do not count. */
	FLogAxis(const std::vector<double>& Values, double InFrom, double InTo);

	/** 0 and below: the axis's start. */
	double Map(double Value) const;
	double GetLow() const { return Low; }
	double GetHigh() const { return High; }
	/** Powers of ten, and simple multiples of these where there are few. */
	std::vector<double> GetTicks() const;

private:
	double Low = 0.1;
	double High = 10.0;
	double From;
	double To;
};

/** About as wide as it will be, at a size of the font in pixels. */
double EstimateTextWidth(const std::string& Text, double FontSize);

/** "0.01", "500", or ten to a power as markup. */
std::string TickMarkup(double Value);

/** Grid, ticks and names of two axes. */
std::string DrawAxes(const FSvgBox& Plot, const FLogAxis& X, const FLogAxis& Y, const std::vector<double>& XTicks,
	const std::string& XName, const std::string& YName);

/** Places labels beside points, one after the other, where nothing is yet. */
class FLabelPlacer
{
public:
	explicit FLabelPlacer(const FSvgBox& InWithin)
		: Within(InWithin)
	{
	}

	void Block(const FSvgBox& Box) { Taken.push_back(Box); }
	/** Within the area, and nothing is there yet. */
	bool IsFree(const FSvgBox& Box) const;
	/** Markup of the label, with a thin line to its point where it had to move away; empty when there is no room. */
	std::string Place(double X, double Y, const std::string& Text, const std::string& Class);

private:
	FSvgBox Within;
	std::vector<FSvgBox> Taken;
};

} // namespace Drydock
