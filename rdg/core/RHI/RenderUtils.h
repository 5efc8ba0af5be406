// Small helpers of rendering code. Source: engine RenderUtils.h.
#pragma once

#include "PixelFormat.h"
#include "RHIStates.h"
#include "RenderResource.h"

/** Alpha of the scene colour reaches the tonemapper; drydock always keeps it. */
inline bool IsPostProcessingWithAlphaChannelSupported()
{
	return true;
}

/** ATTRIBUTE0: so many floats. */
DRYDOCK_API FVertexDeclarationRHIRef& GetVertexDeclarationFVector2();
DRYDOCK_API FVertexDeclarationRHIRef& GetVertexDeclarationFVector3();
DRYDOCK_API FVertexDeclarationRHIRef& GetVertexDeclarationFVector4();
