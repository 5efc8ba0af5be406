// Writes findings as SARIF 2.1.0, the format in which code hosts show them at the lines that they are about. Source:
// OASIS, Static Analysis Results Interchange Format 2.1.0.
#pragma once

#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A message with the rule that it comes from. */
struct FFinding
{
	FDiagnostic Diagnostic;
	std::string Rule = {}; // "Threads" of prove, the id of a rule of lint; empty: the message's number, "DD1012"
};

/** The document of one run. Verb: part of its name. Paths below the working folder are relative to it; a message
 * without a file is about File. */
DRYDOCK_API std::string MakeSarif(
	const std::string& Verb, const std::string& File, const std::vector<FFinding>& Findings);

} // namespace Drydock
