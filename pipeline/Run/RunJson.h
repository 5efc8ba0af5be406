// The machine-readable reports of a run. run.json holds nothing that changes from one run to the next of the same
// config; times are in timing.json and trace.json. Trace.json is Chrome's trace-event format.
#pragma once

#include "Run/RunResult.h"

namespace Drydock
{

std::string MakeRunJson(const FRunResult& Result);

/** SaveMs: how long writing the pictures took. ConfigPath: the config, from the folder of the outputs; empty: left out.
 * The parts add up to wallMs, which is taken for itself, but for what lies
 * between them. */
DRYDOCK_API std::string MakeTimingJson(const FRunResult& Result, double SaveMs, const std::string& ConfigPath = "");

/** Opens in chrome://tracing and ui.perfetto.dev. */
std::string MakeTraceJson(const FRunResult& Result);

/** As the system calls it, or empty. */
std::string GetCpuName();

} // namespace Drydock
