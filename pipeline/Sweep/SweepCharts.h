// Draws the figures of a sweep over its axes, and its pictures side by side.
#pragma once

#include "DrydockAPI.h"
#include "Picture/Chart.h"
#include "Picture/ImageFile.h"
#include "Sweep/SweepTable.h"

namespace Drydock
{

/** The figures over one axis, a panel each. A line is drawn for each combination of the other axes where there are few,
 * else the mean. bSeconds: the time of tasks in place of figures. Nothing to draw where the axis has one value. */
DRYDOCK_API FChart MakeSweepChart(const FSweepTable& Table, size_t Axis, bool bSeconds);

/** Rows of the table for which pictures are shown: all, or evenly chosen ones. */
DRYDOCK_API std::vector<size_t> ChooseSweepRows(const FSweepTable& Table);

/** The last picture of these rows, each with its values. A table without pictures gives an empty sheet. Throws FError
 * (exit code 3) when a picture cannot be read. */
DRYDOCK_API FImage MakeSweepSheet(const FSweepFolder& Folder, const FSweepTable& Table);

} // namespace Drydock
