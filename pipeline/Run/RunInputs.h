// Lists what a run or a sequence depends on beside drydock itself: run.json and sequence.json record it, so that a run
// can be repeated, two runs compared, and a stopped sequence continued.
#pragma once

#include "Budget/RunOptions.h"
#include "Config/Config.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** The inputs by name ("config", "shaders", "file PATH"; of a sequence "drydock", "path", "options", too): a
 * fingerprint, or the text itself. Paths are relative to the config. The number of threads is not an input. */
using FRunInputs = std::map<std::string, std::string>;

/** A console variable that somebody set. */
struct FRunVariable
{
	std::string Name;
	std::string Value;
	std::string SetBy; // "config", "command line", else as the engine calls it: "Console", "Scalability", "Constructor"
};

/** The variables whose values are not drydock's own defaults, by name, as they are now. The number of threads changes
 * no bit and is left out. */
std::vector<FRunVariable> ListRunVariables();

/** Config: of those options. Files that the config names, plugins among them, count by their contents, and so do the
 * ini files of plugins, which are loaded. Throws FError (exit code 3) when a file cannot be read. */
DRYDOCK_API FRunInputs FindRunInputs(const FRunOptions& Options, const FConfig& Config);

/** The same of a sequence, with the options and the build of drydock. The frames' own files do not count. */
DRYDOCK_API FRunInputs FindSequenceInputs(const FRunOptions& Options, FConfig Config);

/** The words of a command line that gives the options which change a bit of the outputs: {"--set", "r.A=1"}. Paths are
 * relative to the config. */
DRYDOCK_API std::vector<std::string> ListRunArguments(const FRunOptions& Options, const FConfig& Config);

/** Adds what such words say to the options of a run of ConfigFile. Returns false if a word is unknown. */
DRYDOCK_API bool TakeRunArguments(
	const std::vector<std::string>& Words, const std::string& ConfigFile, FRunOptions& Options);

/** One part of a sentence for each difference: "the config has changed". */
DRYDOCK_API std::vector<std::string> DescribeChanges(const FRunInputs& Before, const FRunInputs& Now);

} // namespace Drydock
