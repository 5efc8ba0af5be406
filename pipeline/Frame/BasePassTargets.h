// The render targets that PostRenderBasePassDeferred gets. Source: the slots as public plugins
// name them.
#pragma once

#include "SceneTextures.h"

namespace Drydock
{

/** The targets of the engine's base pass, each in its slot: scene colour in 0, GBufferA to GBufferE in 1 to 5, and
 * depth that can be written. All are loaded. A texture that the scene lacks leaves its slot empty. */
FRenderTargetBindingSlots GetBasePassTargets(const FSceneTextures& SceneTextures);

} // namespace Drydock
