// What a binding needs of the graph's resources: the RHI objects behind them, inside a pass that declares them.
// Internal to this folder: keeps the graph's headers out of it. Source: drydock.
#pragma once

#include "RHIFwd.h"
#include "RenderGraphFwd.h"

namespace Drydock
{

FRHITexture* GetTextureRHI(FRDGTexture* Texture);
FRHIShaderResourceView* GetViewRHI(FRDGTextureSRV* View);
FRHIShaderResourceView* GetViewRHI(FRDGBufferSRV* View);
FRHIUnorderedAccessView* GetViewRHI(FRDGTextureUAV* View);
FRHIUnorderedAccessView* GetViewRHI(FRDGBufferUAV* View);

/** The struct that the buffer was created with. */
const void* GetUniformBufferContents(FRDGUniformBuffer* Buffer);

} // namespace Drydock
