// The settings along a sequence's camera path, as a page draws them.
#pragma once

#include "Budget/RunOptions.h"

#include <string>

namespace Drydock
{

/** JSON by "walk" of report/report.schema.json: a walk along the cameras of all frames of the config's scene. Empty:
 * the scene is not a sequence of two frames or more, a frame has no camera, or no setting changes on the way. Loads the
 * config's plugins; no session may live. Throws FError. */
DRYDOCK_API std::string MakeSceneWalkJson(const FRunOptions& Options);

} // namespace Drydock
