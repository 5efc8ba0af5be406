// Evaluates the conditions of #if and #elif: integer expressions over macros and defined().
#pragma once

#include "ShaderMacros.h"

#include <optional>

namespace Drydock
{

/** The value of the expression behind #if, by the rules of C: names that are not macros count as 0, the sides that &&
 * || and ?: skip may divide by zero. Nothing when the expression is wrong; Problem is the reason. */
DRYDOCK_API std::optional<int64_t> EvaluateCondition(
	const std::string& Expression, const FShaderMacros& Macros, std::string& Problem);

} // namespace Drydock
