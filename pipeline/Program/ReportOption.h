// Implements the option `--report` of the verbs that write a page: when the page is written, and how its place is
// reported.
#pragma once

#include "Report/RunReport.h"

#include <filesystem>
#include <string>

namespace Drydock
{

class FVerbOptions;

/** --report: on (where no word follows) or off. Page: what it is, "study.html, the chart ...". bDefault: without the
 * option. */
void AddReport(FVerbOptions& Verb, std::string& Word, const std::string& Page, bool bDefault = true);

/** Decides by the word of --report; without one a report is wanted unless JSON is printed. */
bool WantsReport(const std::string& Word, bool bJson);

/** Chooses the report of a run: by the word of --report; without one by the config's outputs.report; else it is on if
 * bDefault. */
EReport ChooseRunReport(const std::string& Word, const std::string& ConfigFile, bool bDefault);

/** "page     FILE", as a line of what a verb prints. */
void PrintPage(const std::filesystem::path& File);

} // namespace Drydock
