// Summarizes a matrix: one sentence, what to do next, and the exit code. Pure: data in, text out.
#pragma once

#include "DrydockAPI.h"
#include "Matrix/MatrixResult.h"

#include <string>
#include <vector>

namespace Drydock
{

/** "MyTint.cpp:41: text", "DD2086 at plugin libTint.so, SetupView of extension FTint: text". */
DRYDOCK_API std::string DescribeMessage(const FMatrixMessage& Message);

/** Describes the end of a failed run: "crashes: SetupView of extension FTint", "throws: ...", "hangs: ...", "exit 2,
 * DD2015". */
DRYDOCK_API std::string DescribeEnd(const FMatrixRun& Run);

/** "Builds, runs and draws the same under 5.3 to 5.8; 5.1 and 5.2: does not compile, 'X' was not declared in this scope
 * (MyTint.cpp:41)." */
DRYDOCK_API std::string SummarizeMatrix(const FVersionMatrix& Matrix);

/** Advice to the matrix's reader, a line each; none where all is well. */
DRYDOCK_API std::vector<std::string> AdviseOnMatrix(const FVersionMatrix& Matrix);

/** EExitCode: done where every version builds and runs, files where nothing but those kept runs from running, else
 * usage. */
DRYDOCK_API int GetMatrixExitCode(const FVersionMatrix& Matrix);

} // namespace Drydock
