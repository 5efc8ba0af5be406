// Calls those who have registered with the renderer's module. Source: engine files RendererInterface.h, EngineModule.h.
#pragma once

#include "Extensions/ViewExtensions.h"

#include <vector>

class FRDGBuilder;
struct FSceneTextures;

namespace Drydock
{

/** Whether somebody is registered, who may change what the scene textures hold. */
bool HasRendererDelegates();

/** Before post-processing: the post-opaque and overlay delegates for each view, then those of the resolved scene
 * colour. */
void CallRendererDelegates(
	FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views, const FSceneTextures& SceneTextures);

} // namespace Drydock
