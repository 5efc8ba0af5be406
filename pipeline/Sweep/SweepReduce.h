// Makes a table, a sheet, plots and a page of the results of a sweep.
#pragma once

#include "DrydockAPI.h"
#include "Picture/Chart.h"
#include "Sweep/SweepTable.h"

namespace Drydock
{

/** Writes table.json, table.csv, sheet.png, plots/AXIS.svg and timing.csv into the folder, and sweep.html where it is
 * asked for. All but timing.csv and the page are the same bytes for the same tasks. Returns the notes of the table.
 * Throws FError as MakeSweepTable and FOutputFolder. */
DRYDOCK_API std::vector<std::string> ReduceSweep(const FSweepFolder& Folder, bool bPage);

/** Each figure over an axis, a panel each: a line for each combination of the other axes where there are few, else the
 * mean.
 */
DRYDOCK_API std::vector<FChartPanel> MakeSweepPanels(const FSweepPlan& Plan, const FSweepTable& Table, size_t Axis);

} // namespace Drydock
