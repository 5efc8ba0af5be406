// The line of a shader that a front end dies on, which it can no longer say itself.
#pragma once

#include "ShaderCompileRequest.h"

#include <functional>

namespace Drydock
{

struct FCrashPlace
{
	std::string File; // virtual
	int Line = 0;     // 1-based, 0: unknown
	std::string When; // end of the sentence "it was ended by signal 11 on 'Main'"
};

/** Text: flattened, which Dies. The first line up to which the text dies as well, as its `#line` marks count; where
 * only all of it dies, the entry point; none where nothing at all dies too. Dies is called about log2(lines) times. */
DRYDOCK_API FCrashPlace FindCrashPlace(const std::string& Text, const FShaderCompileRequest& Request,
	const std::function<bool(const std::string& Text)>& Dies);

} // namespace Drydock
