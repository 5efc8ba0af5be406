// Gives a view its camera: matrices, direction, and the values of the View uniform buffer that follow from them.
#pragma once

#include "SceneRendering.h"

namespace Drydock
{

/** The camera of Projection with a jitter in clip space, and that of the frame before from the view's state, which then
 * keeps this one for the next. A camera cut has no frame before. ViewRect, PreExposure, ViewState and bCameraCut of the
 * view are set. */
void SetUpCamera(const FSceneViewProjectionData& Projection, FVector2D Jitter, FViewInfo& View);

/** Does so again if code has changed View.ViewMatrices since, by a jitter for one. Call it before the uniform buffer is
 * made. */
void UpdateCamera(FViewInfo& View);

} // namespace Drydock
