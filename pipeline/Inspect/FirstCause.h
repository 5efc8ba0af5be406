// The line of a shader that made the NaN or infinity in a run's picture.
#pragma once

#include "Budget/RunOptions.h"
#include "Diagnostics.h"

namespace Drydock
{

/** Whether a run's messages say that its picture has NaN or infinity which its scene did not have. */
DRYDOCK_API bool MadeNonFinite(const std::vector<FDiagnostic>& Diagnostics);

/** Runs the frame once more and looks at every pass: the first line that makes NaN or infinity of finite numbers, or
 * stores what its format holds as infinity, as a warning DD4010. Empty where no shader is to blame. */
DRYDOCK_API std::vector<FDiagnostic> FindFirstCause(const FRunOptions& Options);

} // namespace Drydock
