// Implements the option --junit FILE: a verb's findings as JUnit XML, whatever else it prints.
#pragma once

#include "Text/JUnit.h"

#include <functional>

namespace Drydock
{

class FVerbOptions;

/** Adds --junit to a verb. Cases: what its cases are, for --help. */
void AddJUnit(FVerbOptions& Verb, std::string& File, const char* Cases);

/** Calls the verb, which fills the suite; then writes the suite to File, where that is not empty. An exception of the
 * call becomes the suite's last case, an error, and is thrown on. Returns what the call returns. Throws FError (exit
 * code 3) where the file cannot be written. */
int CallWithJUnit(const std::string& File, const std::string& SuiteName, const std::function<int(FJUnitSuite&)>& Call);

} // namespace Drydock
