// A list of messages that cannot grow without bound: a text of a million mistakes is not worth a million messages.
#pragma once

#include "Diagnostics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Messages of one severity that a list holds. */
constexpr size_t MaxDiagnostics = 100;

/** Of the message that says how many more there are. */
constexpr int MoreDiagnosticsCode = 1025;

/** Appends to Diagnostics. From the hundred-and-first of one severity on, they are only counted, in a last message of
 * that severity: "and 12 more errors". A message of more than 2000 bytes is cut. */
DRYDOCK_API void AddDiagnostic(std::vector<FDiagnostic>& Diagnostics, FDiagnostic Diagnostic);

/** The list as AddDiagnostic would have made it. */
DRYDOCK_API std::vector<FDiagnostic> LimitDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** What to throw where memory is refused: DD5008, exit code 3. What: what the memory is for, "the texture X, 64 x 64";
 * NumBytes: how much of it, 0 where that is not known. */
DRYDOCK_API FError MakeMemoryError(const std::string& What, uint64_t NumBytes);

} // namespace Drydock
