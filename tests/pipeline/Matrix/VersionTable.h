// Writes the differences between drydock's engine versions as a table for docs/versions.md, made from the tables that
// the program obeys: FEngineProfile, hooks and insertion points.
#pragma once

#include <string>

namespace Drydock
{

/** Markdown: a row for each difference, a column for each version. Behaviour that is the same in all versions has no
 * row. */
std::string MakeVersionTable();

} // namespace Drydock
