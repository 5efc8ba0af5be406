// Writes an instruction with its numbers, as a person would: "pow(-0.25, 2.2)".
#pragma once

#include "SpirvObserver.h"

#include <string>

namespace Drydock
{

/** A number for a message: the shortest text that is the float again. */
DRYDOCK_API std::string FormatReal(double Value);

/** The number in a word of a thread, of any kind; integers with all of their digits. */
std::string FormatWord(const FSpirvThreadView& Thread, uint32_t Word, ESpirvType Kind);

/** Describes one component of the result of arithmetic; by the operation's number where HLSL has no sign or function
 * for it. */
std::string DescribeOperation(
	const FSpirvProgram& Program, const FSpirvThreadView& Thread, const FSpirvStep& Step, uint32_t Component);

} // namespace Drydock
