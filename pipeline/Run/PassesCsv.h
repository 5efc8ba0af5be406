// Writes the passes of a run as a table for spreadsheets.
#pragma once

#include "Run/RunResult.h"

namespace Drydock
{

/** A header line, then a line for each pass that ran: index, name, effect, plugin, shader, how it ran, milliseconds,
 * pixels, texture taps (empty: not known), bytes read and written. Sorted as they ran. Source of the form: RFC 4180. */
DRYDOCK_API std::string MakePassesCsv(const FRunResult& Result);

} // namespace Drydock
