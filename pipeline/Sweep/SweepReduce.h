// Makes one table, sheets, plots and a page of the results of a sweep.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepTable.h"

#include <string>

namespace Drydock
{

/** Writes table.json, table.csv, sheet.png, plots/AXIS.svg, timing.csv, timing/AXIS.svg and, where it is asked for,
 * sweep.html into the folder. All but the timing and the page are the same bytes for the same tasks. Throws FError as
 * MakeSweepTable, and as FOutputFolder. */
DRYDOCK_API FSweepTable ReduceSweep(const FSweepFolder& Folder, bool bPage);

/** JSON by report/sweep.schema.json, for MakeReportPage. When: UTC, as FormatReportTime has it. Throws FError (exit code
 * 3) where a picture cannot be read. */
DRYDOCK_API std::string MakeSweepPageData(
	const FSweepFolder& Folder, const FSweepTable& Table, const std::string& When);

} // namespace Drydock
