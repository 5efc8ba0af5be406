// report.html of a run: everything is gathered and written beside the run's other outputs.
#pragma once

#include "Budget/RunOptions.h"
#include "Run/RunResult.h"

#include <filesystem>
#include <string>

namespace Drydock
{

/** The extent of a report. */
enum class EReport
{
	Off,
	On,
	Full, // the values of all pictures beside their PNG files
};

/** "off", "on" or "full"; On for other words. */
DRYDOCK_API EReport ParseReport(const std::string& Word);

/** Compiles the frame once more with nothing skipped, which shows what skipping saved, unless plugins would be called
 * once more, and blends its settings with their ledger. Then writes report.html into Aside, where the run's other
 * files lie already. Folder: may hold an earlier run's report, which the page shows beside. Options: those of the run,
 * whose sessions have all ended. SaveMs: time that writing the other files took. Throws FError. */
DRYDOCK_API void WriteRunReport(const FRunOptions& Options, const FRunResult& Result, EReport Report,
	const std::filesystem::path& Folder, const std::filesystem::path& Aside, double SaveMs);

/** The data of the same page without large pictures, as report/report.schema.json has it. Result: of Options with
 * bKeepForReport. Throws FError. */
DRYDOCK_API std::string MakeRunReportData(const FRunOptions& Options, const FRunResult& Result);

} // namespace Drydock
