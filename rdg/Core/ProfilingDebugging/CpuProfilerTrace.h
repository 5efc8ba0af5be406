// Profiling scopes under their engine header. Source: engine ProfilingDebugging/CpuProfilerTrace.h.
#pragma once

#include "Stats/Stats.h"
