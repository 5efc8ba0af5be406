// Prints and throws the graph's messages.
#pragma once

#include "Diagnostics.h"
#include "RenderGraphErrors.h"

#include <string>

namespace Drydock
{

/** Prints the message on stderr and throws it: for what must not go on. */
[[noreturn]] DRYDOCK_API void ThrowRDGError(int Code, const std::string& Message, const std::string& Where);

/** Prints all on stderr and throws them together. Must not be empty. */
[[noreturn]] DRYDOCK_API void ThrowRDGErrors(const std::vector<FDiagnostic>& Diagnostics);

/** Reports a failed ensure with the message; returns. */
DRYDOCK_API void ReportRDGEnsure(const FDiagnostic& Diagnostic);

/** Prints a warning on stderr; bOnce: unless the same text was printed before. */
DRYDOCK_API void ReportRDGWarning(const FDiagnostic& Diagnostic, bool bOnce);

} // namespace Drydock
