// Small helpers of rendering code. Source: engine RenderUtils.h.
#pragma once

#include "PixelFormat.h"
#include "RenderResource.h"

/** Alpha of the scene colour reaches the tonemapper; drydock always keeps it. */
inline bool IsPostProcessingWithAlphaChannelSupported()
{
	return true;
}
