// Makes, copies and destroys the result of a run.
#include "Run/RunResult.h"

namespace Drydock
{

DRYDOCK_DEFINE_COPIES(FRunResult)

} // namespace Drydock
