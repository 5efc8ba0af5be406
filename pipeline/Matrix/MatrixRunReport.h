// Reads the results of a run from its output and its run.json. Pure: texts in, data out.
#pragma once

#include "DrydockAPI.h"
#include "Matrix/MatrixResult.h"

#include <string>

namespace Drydock
{

/** The first error of drydock's in what a run printed; where there is none, its last line. */
DRYDOCK_API FMatrixMessage FindFirstError(const std::string& Output);

/** ExitCode: of the run, 128 and more where a signal ended it. Output: what it printed. RunJson: its run.json with
 * fingerprints; read only where the exit code is 0. */
DRYDOCK_API FMatrixRun ReadMatrixRun(int ExitCode, const std::string& Output, const std::string& RunJson);

} // namespace Drydock
