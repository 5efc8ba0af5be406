// How an error stands to the budget of a study.
#pragma once

#include "Budget/StudyConfig.h"
#include "Picture/ImageMetrics.h"

namespace Drydock
{

/** 0 and up, the smaller the better: of psnr and ssim the distance from perfect (10^(-dB/20), 1 - ssim). */
DRYDOCK_API double GetErrorToRank(const FImageError& Error, const std::string& Metric);

/** Whether an error meets the budget's max; always where there is none. */
DRYDOCK_API bool MeetsBudget(const FImageError& Error, const FStudyBudget& Budget);

} // namespace Drydock
