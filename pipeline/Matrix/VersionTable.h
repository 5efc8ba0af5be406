// What drydock does differently from one engine version to the next, as a table for docs/versions.md, made from the
// tables that the program obeys: FEngineProfile, hooks and insertion points.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** Markdown: a row for each difference, a column for each version. What is the same in all of them has no row. */
DRYDOCK_API std::string MakeVersionTable();

} // namespace Drydock
