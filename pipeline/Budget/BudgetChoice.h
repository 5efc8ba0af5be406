// Chooses values for a run from a study: with a budget in its config, the variant that
// the study recommends by it.
#pragma once

#include "Budget/StudyConfig.h"

#include "Budget/RunOptions.h"

namespace Drydock
{

struct FBudgetChoice
{
	std::vector<FStudyAssignment> Set; // empty: the config's own values hold
	std::string Reason;                // a sentence, for run.json and the log
};

/** Empty where the config has no budget or no study. Reads study.json and study_timing.json of budget.study, or of the
 * folder where `drydock study` puts them by default; what they were made of must be this config (its budget may
 * differ). Where a study has several jobs, one variant must meet the budget in all of them, and its time is their sum.
 * Why nothing was chosen is a note in Diagnostics. */
DRYDOCK_API std::optional<FBudgetChoice> ReadBudgetChoice(
	const FConfig& Config, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics);

/** Adds the choice to what a run is asked for; what the command line names beats it. */
DRYDOCK_API void ApplyBudgetChoice(const FBudgetChoice& Choice, FConfig& Config, FRunOptions& Options);

} // namespace Drydock
