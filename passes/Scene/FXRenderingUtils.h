// Declares the functions by which effects outside the renderer may query a view. Source: engine file
// FXRenderingUtils.h.
#pragma once

#include "SceneRendering.h"

namespace UE::FXRenderingUtils
{

/** The view's rect in the scene textures. The view must be the renderer's. */
inline FIntRect GetRawViewRectUnsafe(const FSceneView& View)
{
	check(View.bIsViewInfo);
	return static_cast<const FViewInfo&>(View).ViewRect;
}

} // namespace UE::FXRenderingUtils
