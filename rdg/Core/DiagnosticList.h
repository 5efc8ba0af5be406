// A list of messages that cannot grow without bound: a text of a million mistakes is not worth a million messages.
#pragma once

#include "Diagnostics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Messages of one kind, which is a severity and a number, that a list holds. */
constexpr size_t MaxDiagnostics = 100;

/** Messages of one kind that a person is shown; of more of them only the first. */
constexpr size_t MaxListedAlike = 20;
constexpr size_t NumListedOfMany = 5;

/** Of the message that says how many more there are. */
constexpr int MoreDiagnosticsCode = 1025;

/** Appends to Diagnostics. From the hundred-and-first of one kind on, they are only counted, in a last message of that
 * severity: "and 12 more like it (DD1012)". A message of more than 2000 bytes is cut. */
DRYDOCK_API void AddDiagnostic(std::vector<FDiagnostic>& Diagnostics, FDiagnostic Diagnostic);

/** Appends those of More whose text, as ToString gives it, is not in Diagnostics yet. */
DRYDOCK_API void AddNewDiagnostics(std::vector<FDiagnostic>& Diagnostics, const std::vector<FDiagnostic>& More);

/** The list as AddDiagnostic would have made it. */
DRYDOCK_API std::vector<FDiagnostic> LimitDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** What a person is shown of a list of any length: of a kind with more than MaxListedAlike messages the first
 * NumListedOfMany, then how many more there are. Messages that stand for others count as those. A message of more than
 * 2000 bytes is cut. */
DRYDOCK_API std::vector<FDiagnostic> SummarizeDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** What to throw where memory is refused: DD5008, exit code 3. What: what the memory is for, "the texture X, 64 x 64";
 * NumBytes: how much of it, 0 where that is not known. */
DRYDOCK_API FError MakeMemoryError(const std::string& What, uint64_t NumBytes);

} // namespace Drydock
