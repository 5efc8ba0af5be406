// Ranks the variants of a study: which dominate others, which differ only by noise, and which a budget recommends.
// Pure: from figures to words.
#pragma once

#include "Study/StudyResult.h"

namespace Drydock
{

/** Median and quartiles; by interpolation between the sorted runs. */
DRYDOCK_API FStudyTime SummarizeRuns(std::vector<double> Runs);

/** Fills ranks, noise and recommendations of all jobs. The front of a job holds the variants that no other dominates. A
 * dominates B when A is not worse in error and cost, and better in one; plain code does not dominate shaders, and is
 * not recommended, because it cannot run where they do. The recommended variant is the choice of ChooseWithinBudget by
 * time; if none meets the budget, there is none. */
DRYDOCK_API void RankStudy(FStudyResult& Result);

} // namespace Drydock
