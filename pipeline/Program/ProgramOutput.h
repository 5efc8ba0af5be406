// What verbs say to a person or a script beside their results: messages, and which effects do not run.
#pragma once

#include "Diagnostics.h"

#include <vector>

namespace Drydock
{

class FJsonWriter;
struct FEffectDecision;

/** Writes an array of objects, for editors and scripts. */
void WriteDiagnostics(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics);

/** Prints diagnostics to stderr, one a line, coloured on a terminal (unless NO_COLOR is set). */
DRYDOCK_API void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** Prints to stderr one line for each effect that was configured and does not run, and why. */
void PrintClosingLines(const std::vector<FEffectDecision>& Effects);

} // namespace Drydock
