// The render thread's side of a UTexture. FTexture and its kin lie in RenderResource.h. Source: engine
// TextureResource.h.
#pragma once

#include "RenderResource.h"

class DRYDOCK_API FTextureResource : public FTexture
{
public:
	FRHITexture* GetTexture2DRHI() const { return TextureRHI; }
	FRHITexture* GetTexture3DRHI() const { return TextureRHI; }
};
