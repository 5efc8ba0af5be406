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

/** Code of the message that counts the messages left out. */
constexpr int MoreDiagnosticsCode = 1025;

/** Appends to Diagnostics. From the hundred-and-first of one kind on, they are only counted, in a last message of that
 * severity: "and 12 more like it (DD1012)". A message is cut where its first line has more than 2000 bytes, and at
 * 64000 bytes: a table of many lines stays whole. */
DRYDOCK_API void AddDiagnostic(std::vector<FDiagnostic>& Diagnostics, FDiagnostic Diagnostic);

/** Appends those of More whose text, as ToString gives it, is not in Diagnostics yet. */
DRYDOCK_API void AddNewDiagnostics(std::vector<FDiagnostic>& Diagnostics, const std::vector<FDiagnostic>& More);

/** The list as AddDiagnostic would have made it. */
DRYDOCK_API std::vector<FDiagnostic> LimitDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** Shortens a list of any length for people. A kind with more than MaxListedAlike messages keeps the first
 * NumListedOfMany, then a message counts the rest. A message that represents several counts as that many.
 * Messages are cut as by AddDiagnostic. */
DRYDOCK_API std::vector<FDiagnostic> SummarizeDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** The error to throw when memory is refused: DD5008, exit code 3. The argument What names the memory's use, "the
 * texture X, 64 x 64"; NumBytes: how much of it, 0 where that is not known. */
DRYDOCK_API FError MakeMemoryError(const std::string& What, uint64_t NumBytes);

} // namespace Drydock
