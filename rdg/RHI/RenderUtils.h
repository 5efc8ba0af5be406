// Small helpers of rendering code. Source: engine RenderUtils.h.
#pragma once

#include "PixelFormat.h"
#include "RenderResource.h"

/** Quads of the engine's plain dummies: white and black in every shape exist through RenderResource.h. */
inline bool RHIPixelFormatHasCapabilities(EPixelFormat Format, uint64 = 0)
{
	return GPixelFormats[Format].Supported;
}

inline bool IsPixelFormatSupported(EPixelFormat Format)
{
	return GPixelFormats[Format].Supported;
}

/** Alpha of the scene colour reaches the tonemapper; drydock always keeps it. */
inline bool IsPostProcessingWithAlphaChannelSupported()
{
	return true;
}
