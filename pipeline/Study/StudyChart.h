// Charts of a study: the error of every variant against its cost.
#pragma once

#include "Picture/Chart.h"
#include "Study/StudyResult.h"

namespace Drydock
{

/** One job: a point for each variant. The cost is on x, and the error by Metric on y; smaller is better. */
DRYDOCK_API FChartPanel MakeStudyPanel(
	const FStudyResult& Result, const FStudyJob& Job, EStudyCost Cost, const std::string& Metric);

/** A study by the metric that it ranks by: a panel for each job. If jobs differ by a number, such as a width, panels of
 * cost and error against it come first, and only the jobs of the first of the other values have panels of their own.
 * Over taps the chart is the same on every run. */
DRYDOCK_API FChart MakeStudyChart(const FStudyResult& Result, EStudyCost Cost);

} // namespace Drydock
