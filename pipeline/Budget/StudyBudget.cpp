// Ranks an error by its metric and holds it against a budget.
#include "Budget/StudyBudget.h"

#include <cmath>
#include <tuple>

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

std::optional<size_t> ChooseWithinBudget(const std::vector<FBudgetCandidate>& Candidates, const FStudyBudget& Budget)
{
	const auto GetOrder = [&Budget](const FBudgetCandidate& Candidate)
	{
		return std::tuple(Budget.Max ? 0.0 : Candidate.Error, Candidate.Median);
	};
	std::optional<size_t> First;
	for (size_t Index = 0; Index < Candidates.size(); ++Index)
	{
		const bool bBetter = !First || GetOrder(Candidates[Index]) < GetOrder(Candidates[*First]);
		First = Candidates[Index].bMeets && bBetter ? Index : First;
	}
	std::optional<size_t> Best;
	for (size_t Index = 0; First && Index < Candidates.size(); ++Index)
	{
		const FBudgetCandidate& Candidate = Candidates[Index];
		const bool bAsCheap = Candidate.bMeets && Candidate.IsWithinNoiseOf(Candidates[*First]);
		Best = bAsCheap && (!Best || Candidate.Error < Candidates[*Best].Error) ? Index : Best;
	}
	return Best;
}

} // namespace Drydock
