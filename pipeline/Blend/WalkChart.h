// A walk as a chart: the volumes' weights along the path, then a panel for each setting over shades of the volumes.
#pragma once

#include "Picture/Chart.h"

namespace Drydock
{

struct FSettingsWalk;

/** The settings of a walk that can be drawn: all but objects and arrays. x is the distance along the path, cm. Marks
 * are the path's points; MarkName: what their labels are. */
DRYDOCK_API FChart MakeWalkChart(const FSettingsWalk& Walk, const std::string& Title, const std::string& MarkName);

} // namespace Drydock
