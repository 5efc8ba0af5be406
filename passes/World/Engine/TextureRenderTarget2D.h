// A texture that code draws to and reads from across frames; it has pixels. Source: engine files
// Engine/TextureRenderTarget2D.h, Engine/TextureRenderTarget.h, TextureResource.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/Texture.h"
#include "RenderTargetPool.h"
#include "TextureResource.h"
#include "UnrealClient.h"

enum ETextureRenderTargetFormat : int
{
	RTF_R8,
	RTF_RG8,
	RTF_RGBA8,
	RTF_RGBA8_SRGB,
	RTF_R16f,
	RTF_RG16f,
	RTF_RGBA16f,
	RTF_R32f,
	RTF_RG32f,
	RTF_RGBA32f,
	RTF_RGB10A2,
};

DRYDOCK_API EPixelFormat GetPixelFormatFromRenderTargetFormat(ETextureRenderTargetFormat Format);

/** The pixels of a target, on the render thread. */
class DRYDOCK_API FTextureRenderTargetResource : public FTextureResource, public FRenderTarget
{
public:
	using FRenderTarget::GetRenderTargetTexture;
	const FTextureRHIRef& GetRenderTargetTexture() const override { return TextureRHI; }
	FIntPoint GetSizeXY() const override
	{
		return FIntPoint(static_cast<int32>(GetSizeX()), static_cast<int32>(GetSizeY()));
	}
};

class DRYDOCK_API UTextureRenderTarget : public UTexture
{
public:
	DRYDOCK_CLASS(UTextureRenderTarget, UTexture)
	using UTexture::UTexture;

	/** Null until the target has a size. */
	FTextureRenderTargetResource* GetRenderTargetResource() const;
	FTextureRenderTargetResource* GameThread_GetRenderTargetResource() const { return GetRenderTargetResource(); }
};

class DRYDOCK_API UTextureRenderTarget2D : public UTextureRenderTarget
{
public:
	DRYDOCK_CLASS(UTextureRenderTarget2D, UTextureRenderTarget)

	UTextureRenderTarget2D();
	~UTextureRenderTarget2D() override;

	int32 SizeX = 0; // texels
	int32 SizeY = 0;
	FLinearColor ClearColor = FLinearColor(0.0f, 1.0f, 0.0f);
	ETextureRenderTargetFormat RenderTargetFormat = RTF_RGBA16f;
	EPixelFormat OverrideFormat = PF_Unknown;
	bool bAutoGenerateMips = false;
	bool bCanCreateUAV = false;

	float GetSurfaceWidth() const override { return static_cast<float>(SizeX); }
	float GetSurfaceHeight() const override { return static_cast<float>(SizeY); }

	/** OverrideFormat, or what RenderTargetFormat means. */
	EPixelFormat GetFormat() const;
	/** Initializes with the format of RenderTargetFormat. */
	void InitAutoFormat(int32 InSizeX, int32 InSizeY);
	void InitCustomFormat(int32 InSizeX, int32 InSizeY, EPixelFormat InFormat, bool bInForceLinearGamma);
	void ResizeTarget(int32 InSizeX, int32 InSizeY) { InitAutoFormat(InSizeX, InSizeY); }
	/** Makes the texture anew, from the members. */
	void UpdateResource();
	void UpdateResourceImmediate(bool bClearRenderTarget = true);

private:
	std::unique_ptr<FTextureRenderTargetResource> TargetResource;
};
