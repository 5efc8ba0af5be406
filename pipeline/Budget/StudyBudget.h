// Compares an error with the budget of a study.
#pragma once

#include "Budget/StudyConfig.h"
#include "Picture/ImageMetrics.h"

namespace Drydock
{

/** 0 and up, the smaller the better: of psnr and ssim the distance from perfect (10^(-dB/20), 1 - ssim). */
DRYDOCK_API double GetErrorToRank(const FImageError& Error, const std::string& Metric);

/** Whether an error meets the budget's max; always where there is none. */
DRYDOCK_API bool MeetsBudget(const FImageError& Error, const FStudyBudget& Budget);

/** A variant that may be chosen, or not. */
struct FBudgetCandidate
{
	bool bMeets = true; // it ran, is what was asked for, and is within the bounds
	double Error = 0.0; // as GetErrorToRank has it
	double Median = 0.0;
	double Low = 0.0; // quartiles of the times
	double High = 0.0;

	bool IsWithinNoiseOf(const FBudgetCandidate& Other) const { return Low <= Other.High && Other.Low <= High; }
};

/** The rule of `study` and of `run`: the cheapest variant where the budget bounds the error, else the most exact. Among
 * variants that are equally cheap within noise the most exact is taken. Among equally exact ones, such as variants with
 * the same bits, the first in the study's order is taken, whatever their times. Empty where none meets the budget. */
DRYDOCK_API std::optional<size_t> ChooseWithinBudget(
	const std::vector<FBudgetCandidate>& Candidates, const FStudyBudget& Budget);

} // namespace Drydock
