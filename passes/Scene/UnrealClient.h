// What can be drawn to. Source: engine file UnrealClient.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"

class DRYDOCK_API FRenderTarget
{
public:
	virtual ~FRenderTarget();

	virtual const FTextureRHIRef& GetRenderTargetTexture() const = 0;
	/** Texels. */
	virtual FIntPoint GetSizeXY() const = 0;
};
