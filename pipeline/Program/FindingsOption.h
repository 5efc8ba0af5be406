// Implements the options --junit, --sarif and --fail-on: a verb's findings for build servers and code hosts, whatever
// else the verb prints.
#pragma once

#include "Text/JUnit.h"

#include <functional>

namespace Drydock
{

class FVerbOptions;

struct FFindingsOptions
{
	std::string JUnit; // file to write; empty: none
	std::string Sarif; // file to write; empty: none
	bool bFailOnWarning = false;
};

/** Adds the options to a verb. Cases: what its cases are, for --help. */
void AddFindings(FVerbOptions& Verb, FFindingsOptions& Options, const char* Cases);

/** A case for each family of messages, which are told apart by the thousands of their numbers. */
std::vector<FJUnitCase> MakeDiagnosticCases(const std::vector<FDiagnostic>& Diagnostics);

/** Calls the verb, which fills the suite; then writes the files that the options name. The messages that the verb
 * printed are findings. An exception of the call becomes the suite's last case, an error, and is thrown on. Returns
 * what the call returns; ExitPolicy where a finding is a warning, and warnings fail. Verb: for SARIF. About: what the
 * suite is about, and the file of the messages that name none. Throws FError (exit code 3) where a file cannot be
 * written. */
int CallWithFindings(const FFindingsOptions& Options, const std::string& Verb, const std::string& About,
	const std::function<int(FJUnitSuite&)>& Call);

} // namespace Drydock
