// A volume that code draws to, which has texels. Source: engine file Engine/TextureRenderTargetVolume.h.
#pragma once

#include "Engine/TextureRenderTarget2D.h"

class DRYDOCK_API UTextureRenderTargetVolume : public UTextureRenderTarget
{
public:
	DRYDOCK_CLASS(UTextureRenderTargetVolume, UTextureRenderTarget)
	using UTextureRenderTarget::UTextureRenderTarget;

	int32 SizeX = 0; // texels
	int32 SizeY = 0;
	int32 SizeZ = 0;
	FLinearColor ClearColor = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f);
	bool bCanCreateUAV = false;

	float GetSurfaceWidth() const override { return static_cast<float>(SizeX); }
	float GetSurfaceHeight() const override { return static_cast<float>(SizeY); }
	void Init(int32 InSizeX, int32 InSizeY, int32 InSizeZ, EPixelFormat InFormat);
	void UpdateResourceImmediate(bool bClearRenderTarget = true);

private:
	EPixelFormat Format = PF_FloatRGBA;
	std::shared_ptr<FTextureRenderTargetResource> TargetResource;
};
