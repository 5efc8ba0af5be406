// r.RDG.ClobberResources: fills a resource with a value that shows, so that reads of what nobody wrote do not go
// unnoticed. Internal to this folder. Source: engine RenderGraphPrivate.cpp (values), restated.
#pragma once

#include "RHIResources.h"

namespace Drydock
{

/** Mode 1: 1000, 2: NaN, 3: +Inf in every channel (depth 0.123456789, stencil 123 in any mode; integers 1000). */
void ClobberTexture(FRHITexture& Texture, int32 Mode);

/** 0 in all texels of all planes. */
void ZeroTexture(FRHITexture& Texture);

void ZeroBuffer(FRHIBuffer& Buffer);

/** The same value as 32-bit floats; a rest of less than four bytes stays. */
void ClobberBuffer(FRHIBuffer& Buffer, int32 Mode);

} // namespace Drydock
