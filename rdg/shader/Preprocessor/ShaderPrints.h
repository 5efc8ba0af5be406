// DrydockPrint, DrydockAssert and the texts of the engine's ShaderPrint in a shader: HLSL has no strings, so they
// become numbers, and kernels are made without them.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Text: preprocessed, without comments. bKeep: `DrydockPrint("%f of %d", A, B)` becomes calls of DrydockPrintText,
 * DrydockPrintValue and DrydockPrintEnd, `DrydockAssert(X)` one of DrydockAssertValue; else they vanish.
 * `DrydockText("...")`, which TEXT of ShaderPrint.ush stands for, always becomes its number. Strings: the texts by
 * these numbers; of an assertion its condition. Lines stay where they are. */
DRYDOCK_API std::string RewritePrints(const std::string& Text, bool bKeep, std::vector<std::string>& Strings);

/** Declarations of the functions that the calls need, in one line; empty where there are no calls. */
DRYDOCK_API std::string DeclarePrints(const std::string& Rewritten);

} // namespace Drydock
