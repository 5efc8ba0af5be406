// Reads from a run's own record how to repeat it.
#pragma once

#include "Run/RunInputs.h"

#include <string>

namespace Drydock
{

/** A run as its run.json records it. */
struct FRunAgain
{
	FRunOptions Options;
	FRunInputs Inputs; // what it depended on
};

/** RunJson: the file. The config is where timing.json beside it says, unless ConfigFile names one. Throws FError: a
 * file that cannot be read (exit code 3); a record by which nothing can be repeated, such as that of a frame with
 * the history of another (exit code 2). */
DRYDOCK_API FRunAgain ReadRunAgain(const std::string& RunJson, const std::string& ConfigFile = "");

/** A warning if something that the run depended on is different now. Now: the inputs of its repetition. */
DRYDOCK_API std::vector<FDiagnostic> FindChangedInputs(
	const FRunInputs& Before, const FRunInputs& Now, const std::string& RunJson);

} // namespace Drydock
