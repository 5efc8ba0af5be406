// Holds what a chart shows of a study: one of its costs against the metric that it ranks by. Inner to StudyChart.
#pragma once

#include "Study/StudyPanel.h"
#include "Study/StudyResult.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FStudyView
{
	const FStudyResult& Result;
	EStudyCost Cost;

	double GetCost(const FStudyVariant& Variant) const;
	/** Smaller is better, whatever the metric. */
	double GetError(const FStudyVariant& Variant) const;
	/** Whether a variant is recommended. This depends on time, so it is not shown in a chart over taps, which are the
	 * same on every run. */
	bool IsRecommended(const FStudyVariant& Variant) const;
	const FStudyRank& GetRank(const FStudyVariant& Variant) const;
	std::string GetCostName() const;
	size_t GetNumChoices() const;

	/** The error that the budget allows, where it speaks of what is drawn. */
	std::optional<double> GetBudgetError() const;
	/** The line of the budget and the area within it. Nothing where the axis does not reach it. */
	std::string DrawBudget(const FSvgBox& Plot, const FLogAxis& Y) const;
};

/** The error axis of a panel. A few errors a thousand times smaller than all others would push these together: they are
 * drawn at the lower edge, and their labels have the figure. */
class FErrorAxis
{
public:
	/** Errors: of all that is drawn. Shown: more that the axis must reach. */
	FErrorAxis(const std::vector<double>& Errors, const std::vector<double>& Shown, const FSvgBox& Plot);

	bool IsBelow(double Error) const { return Error < Floor; }
	double Map(double Error) const;
	/** "FFT", or where it is below "FFT: 2e-7". */
	std::string Label(const std::string& Name, double Error) const;
	const FLogAxis& GetAxis() const { return Axis; }

private:
	static double FindFloor(std::vector<double> Errors);

	double Floor = 0.0;
	FLogAxis Axis;
	double Edge; // where what is below is drawn
};

} // namespace Drydock
