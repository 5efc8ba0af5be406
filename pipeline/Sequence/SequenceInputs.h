// The inputs of a sequence besides its frames. While they are the same, a stopped run may resume; if they differ, the
// existing frames belong to another sequence.
#pragma once

#include "Budget/RunOptions.h"
#include "Config/Config.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** By what it is ("drydock", "config", "options", "shaders", "file PATH"): a fingerprint, or the text itself. Threads
 * are no part of it. */
using FSequenceInputs = std::map<std::string, std::string>;

/** Config: of those options. Files that the config names, plugins among them, count by their contents, and so do the
 * ini files of plugins, which are loaded; frames do not count. Throws FError (exit code 3) when a file cannot be read.
 */
DRYDOCK_API FSequenceInputs FindSequenceInputs(const FRunOptions& Options, const FConfig& Config);

/** One part of a sentence for each difference: "the config has changed". */
DRYDOCK_API std::vector<std::string> DescribeChanges(const FSequenceInputs& Before, const FSequenceInputs& Now);

} // namespace Drydock
