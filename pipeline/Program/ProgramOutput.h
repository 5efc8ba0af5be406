// Prints what verbs report to a person or a script beside their results: messages, and which effects do not run.
#pragma once

#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

class FJsonWriter;
struct FEffectDecision;

/** Writes an array of objects, for editors and scripts: every message that was collected, with severity, code, text,
 * file, line, column (0: unknown), pointer (into the config; else empty), where and the nearest valid name that it
 * offers. */
void WriteDiagnostics(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics);

/** Writes {"messages": ...}, what a verb with --json prints in place of a result. */
void WriteMessages(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics);

/** Prints diagnostics to stderr, as many as SummarizeDiagnostics keeps, one a line, coloured on a terminal (unless
 * NO_COLOR is set). */
DRYDOCK_API void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** While it lives, it keeps what PrintDiagnostics is given; the innermost one does. */
class FScopedPrintedDiagnostics
{
public:
	FScopedPrintedDiagnostics();
	~FScopedPrintedDiagnostics();
	FScopedPrintedDiagnostics(const FScopedPrintedDiagnostics&) = delete;
	FScopedPrintedDiagnostics& operator=(const FScopedPrintedDiagnostics&) = delete;

	const std::vector<FDiagnostic>& Get() const { return Printed; }

private:
	std::vector<FDiagnostic> Printed;
	std::vector<FDiagnostic>* const Outer;
};

/** Columns of the terminal that stdout is; 0 where it is none. */
int GetOutputWidth();

/** The texts, each in an indented line. */
std::string ListLines(const std::vector<std::string>& Texts);

/** Prints what a verb found to stdout. JSON goes out as it is; the lines of a text fit the terminal (FitLines). */
void PrintResult(const std::string& Text, bool bJson = false);

/** Flushes stdout. Throws FError (exit code 3) if some of it could not be written: the disk is full, the pipe has no
 * reader, or stdout is closed. */
DRYDOCK_API void FlushOutput();

/** Holds the places of stdin, stdout and stderr where they are closed. The next file that is opened would get their
 * number, and what is printed would go into it. */
DRYDOCK_API void HoldStandardStreams();

/** Prints to stderr one line for each effect that was configured and does not run, and why. */
void PrintClosingLines(const std::vector<FEffectDecision>& Effects);

} // namespace Drydock
