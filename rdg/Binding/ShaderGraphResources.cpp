// The RHI objects behind the graph's resources. Source: drydock.
#include "ShaderGraphResources.h"

#include "RenderGraphResources.h"

namespace Drydock
{

FRHITexture* GetTextureRHI(FRDGTexture* Texture)
{
	return Texture->GetRHI();
}

FRHIShaderResourceView* GetViewRHI(FRDGTextureSRV* View)
{
	return View->GetRHI();
}

FRHIShaderResourceView* GetViewRHI(FRDGBufferSRV* View)
{
	return View->GetRHI();
}

FRHIUnorderedAccessView* GetViewRHI(FRDGTextureUAV* View)
{
	return View->GetRHI();
}

FRHIUnorderedAccessView* GetViewRHI(FRDGBufferUAV* View)
{
	return View->GetRHI();
}

const void* GetUniformBufferContents(FRDGUniformBuffer* Buffer)
{
	return Buffer->GetContents();
}

} // namespace Drydock
