// Ranks an error by its metric and holds it against a budget.
#include "Budget/StudyBudget.h"

#include <cmath>

namespace Drydock
{

double GetErrorToRank(const FImageError& Error, const std::string& Metric)
{
	const double Value = GetMetric(Error, Metric);
	return Metric == "psnr" ? std::pow(10.0, -Value / 20.0) : Metric == "ssim" ? 1.0 - Value : Value;
}

bool MeetsBudget(const FImageError& Error, const FStudyBudget& Budget)
{
	if (!Budget.Max)
	{
		return true;
	}
	const double Value = GetMetric(Error, Budget.Metric);
	return IsHigherBetter(Budget.Metric) ? Value >= *Budget.Max : Value <= *Budget.Max;
}

} // namespace Drydock
