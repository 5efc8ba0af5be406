// Writes JUnit XML, the format in which build and test servers show results: suites of cases.
#pragma once

#include "DrydockAPI.h"
#include "Text/Sarif.h"

#include <string>
#include <vector>

namespace Drydock
{

enum class EJUnitOutcome
{
	Passed,
	Failed,  // what was asked for does not hold
	Broken,  // it could not be asked: a mistake in the config, a missing file
	Skipped, // it was not asked
};

struct FJUnitCase
{
	std::string Name;
	EJUnitOutcome Outcome = EJUnitOutcome::Passed;
	std::string Message = {}; // why it did not pass; its first line stands in the overview
	std::string Output = {};  // what else there is to know
	double Seconds = 0.0;
	std::string Rule = {}; // of the finding that a failed case is; empty: its messages are the findings
};

struct FJUnitSuite
{
	std::string Name; // of the config; also the class of its cases
	std::vector<FJUnitCase> Cases = {};
	std::vector<FFinding> Findings = {}; // for SARIF: what is not printed as a message
};

/** The document, as the schemas of Jenkins and Surefire have it. Characters that XML cannot hold become question marks.
 */
DRYDOCK_API std::string MakeJUnit(const std::vector<FJUnitSuite>& Suites);

/** Writes it aside and puts it in place. Throws FError (exit code 3). */
DRYDOCK_API void WriteJUnit(const std::string& File, const std::vector<FJUnitSuite>& Suites);

} // namespace Drydock
