// Whether buffers are equal by the suite's rules.
#pragma once

#include "ConformanceTest.h"

namespace Drydock::Conformance
{

/** The first value that differs, with what was expected; empty where all are equal. */
std::string FindDifference(const FBuffer& Actual, const FBuffer& Expected, const FResult& Result);

/** Makes value Index of the buffer (of all its members) another one, beyond any tolerance that a test has. */
void ChangeValue(FBuffer& Buffer, size_t Index);

/** How many values ChangeValue can change. */
size_t CountValues(const FBuffer& Buffer);

} // namespace Drydock::Conformance
