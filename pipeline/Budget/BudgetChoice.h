// Chooses a variant of a study for a run: the one that the study recommends by the budget in the config.
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
 * folder where `drydock study` puts them by default; they must have been made from this config (its budget may differ).
 * If a study has several jobs, one variant must meet the budget in all of them, and its time is their sum. If nothing
 * was chosen, a note in Diagnostics gives the reason. */
DRYDOCK_API std::optional<FBudgetChoice> ReadBudgetChoice(
	const FConfig& Config, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics);

/** Adds the choice to what a run is asked for; what the command line names beats it. */
DRYDOCK_API void ApplyBudgetChoice(const FBudgetChoice& Choice, FConfig& Config, FRunOptions& Options);

} // namespace Drydock
