// Charts as JSON, for the pages that draw them.
#pragma once

#include "Picture/Chart.h"
#include "Text/JsonWriter.h"

namespace Drydock
{

/** The schema is "panel" of report/report.schema.json. */
void WriteChartPanel(FJsonWriter& Writer, const FChartPanel& Panel);

/** The schema is "chart" of report/report.schema.json. */
void WriteChart(FJsonWriter& Writer, const FChart& Chart);

} // namespace Drydock
