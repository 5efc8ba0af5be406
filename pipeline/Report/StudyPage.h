// Writes the data of a study's page as one JSON: its figures, its times, and pictures of some variants.
#pragma once

#include "Study/StudyInsetSheet.h"
#include "Study/StudyResult.h"

#include <string>
#include <vector>

namespace Drydock
{

/** JSON by report/study.schema.json, for MakeReportPage. When: UTC, as FormatReportTime has it. */
DRYDOCK_API std::string MakeStudyPageData(
	const FStudyResult& Result, const std::vector<FStudyInsetRow>& Insets, const std::string& When);

} // namespace Drydock
