// Sets the factor of scene colour before it is stored: a number, or the exposure that it follows.
#pragma once

#include "SceneViewState.h"

#include <vector>

namespace Drydock
{

struct FConfig;

/** Sets PreExposure of all views, which share the scene's textures: r.EyeAdaptation.PreExposureOverride where it is
 * above 0, else view.preExposure of the first view. "auto" follows the exposure scale, as in the engine: of an
 * automatic exposure what the frame before left in Last, and 1 where there was none; of another ExposureScale, which
 * every frame has. A scale that is not finite or not above 0 counts as 1. Last: by view; empty before the first frame.
 */
DRYDOCK_API void SetPreExposure(FConfig& Config, float ExposureScale, const std::vector<FViewHistory>& Last);

} // namespace Drydock
