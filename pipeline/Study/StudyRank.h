// Who dominates whom, what is within noise, and what a budget recommends: pure, from figures to words.
#pragma once

#include "Study/StudyResult.h"

namespace Drydock
{

/** Median and quartiles; by interpolation between the sorted runs. */
DRYDOCK_API FStudyTime SummarizeRuns(std::vector<double> Runs);

/** Fills ranks, noise and recommendations of all jobs. Of each job: the front holds whom nobody dominates; A dominates
 * B when A is no worse in error and cost, and better in one; plain code does not dominate shaders, and is not
 * recommended, for it cannot run where they do. Recommended is what ChooseWithinBudget takes by
 * time; where none meets the budget, none. */
DRYDOCK_API void RankStudy(FStudyResult& Result);

} // namespace Drydock
