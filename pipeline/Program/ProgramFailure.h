// Turns the failure that ended a verb into messages and an exit code: the one place that decides who is to blame.
#pragma once

#include "Diagnostics.h"

#include <exception>

namespace Drydock
{

/** The FError for an exception. Files that the system refuses, and memory or threads that it does not give, are exit
 * code 3 and named. An unforeseen exception is a fault of drydock's own, exit code 70. */
DRYDOCK_API FError ExplainFailure(const std::exception_ptr& Thrown);

/** Throws FError (DD5009, exit code 3) where the system gives threads a stack that is too small for a run. */
DRYDOCK_API void CheckStack();

} // namespace Drydock
