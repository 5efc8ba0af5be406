// Implements the option `--report` of the verbs that write a page: when the page is written, and how its place is
// reported.
#pragma once

#include "Report/RunReport.h"

#include <filesystem>
#include <string>

namespace Drydock
{

class FVerbOptions;

/** --report: on (where no word follows) or off. Page: what it is, "study.html, the chart ...". */
void AddReport(FVerbOptions& Verb, std::string& Word, const std::string& Page);

/** Decides by the word of --report; without one a report is wanted if stdout is a terminal and no JSON is printed. */
bool WantsReport(const std::string& Word, bool bJson);

/** Chooses the report of a run: by the word of --report; without one by the config's outputs.report; else it is on if
 * bLookedAt. */
EReport ChooseRunReport(const std::string& Word, const std::string& ConfigFile, bool bLookedAt);

/** "page     FILE", as a line of what a verb prints. */
void PrintPage(const std::filesystem::path& File);

} // namespace Drydock
