// Declares the render target interface and the window that a frame is drawn for. Source: engine file UnrealClient.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"
#include "RenderGraphFwd.h"

class DRYDOCK_API FRenderTarget
{
public:
	virtual ~FRenderTarget();

	virtual const FTextureRHIRef& GetRenderTargetTexture() const = 0;
	/** Registered in a graph; null where there is no texture. */
	FRDGTextureRef GetRenderTargetTexture(FRDGBuilder& GraphBuilder) const;
	/** Texels. */
	virtual FIntPoint GetSizeXY() const = 0;
	virtual float GetDisplayGamma() const { return 2.2f; }
	/** Row by row; an empty rectangle means all. False where there is no texture. */
	bool ReadPixels(TArray<FColor>& OutImageData, FReadSurfaceDataFlags Flags = FReadSurfaceDataFlags(RCM_UNorm),
		FIntRect Rect = FIntRect()) const;
	bool ReadLinearColorPixels(TArray<FLinearColor>& OutImageData,
		FReadSurfaceDataFlags Flags = FReadSurfaceDataFlags(RCM_MinMax), FIntRect Rect = FIntRect()) const;
};

/** The frame's target, as an extension's context shows it: there is no window behind it. */
class FViewport : public FRenderTarget
{
public:
	/** Target must outlive it. */
	explicit FViewport(const FRenderTarget& InTarget)
		: Target(InTarget)
	{
	}
	const FTextureRHIRef& GetRenderTargetTexture() const override { return Target.GetRenderTargetTexture(); }
	FIntPoint GetSizeXY() const override { return Target.GetSizeXY(); }

private:
	const FRenderTarget& Target;
};
