// Throws the graph's errors and prints its other messages.
#pragma once

#include "Diagnostics.h"
#include "RenderGraphErrors.h"

#include <string>

namespace Drydock
{

/** Throws the message: for what must not go on. */
[[noreturn]] DRYDOCK_API void ThrowRDGError(int Code, const std::string& Message, const std::string& Where);

/** Throws them together; whoever catches them prints them. Must not be empty. */
[[noreturn]] DRYDOCK_API void ThrowRDGErrors(const std::vector<FDiagnostic>& Diagnostics);

/** Reports a failed ensure with the message; returns. */
DRYDOCK_API void ReportRDGEnsure(const FDiagnostic& Diagnostic);

/** Prints a warning on stderr; bOnce: unless the same text was printed before. */
DRYDOCK_API void ReportRDGWarning(const FDiagnostic& Diagnostic, bool bOnce);

} // namespace Drydock
