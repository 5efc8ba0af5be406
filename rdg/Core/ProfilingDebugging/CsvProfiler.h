// Profiling scopes under their engine header. Source: engine ProfilingDebugging/CsvProfiler.h.
#pragma once

#include "Stats/Stats.h"
