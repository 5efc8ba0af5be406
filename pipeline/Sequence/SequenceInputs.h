// Lists the inputs that the pictures of a sequence depend on besides its frames. While they are the same, a stopped run
// may go on; otherwise the frames in the folder belong to another sequence.
#pragma once

#include "Budget/RunOptions.h"
#include "Config/Config.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** The inputs by name ("drydock", "config", "options", "shaders", "file PATH"): a fingerprint, or the text itself. The
 * number of threads is not an input. */
using FSequenceInputs = std::map<std::string, std::string>;

/** Config: of those options. Files that the config names, plugins among them, count by their contents, and so do the
 * ini files of plugins, which are loaded; frames do not count. Throws FError (exit code 3) when a file cannot be read.
 */
DRYDOCK_API FSequenceInputs FindSequenceInputs(const FRunOptions& Options, const FConfig& Config);

/** One part of a sentence for each difference: "the config has changed". */
DRYDOCK_API std::vector<std::string> DescribeChanges(const FSequenceInputs& Before, const FSequenceInputs& Now);

} // namespace Drydock
