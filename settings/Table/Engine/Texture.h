// Textures as settings name them: an identity without pixels, unless code or a config gives it some. Source: engine
// Engine/Texture.h, Engine/Texture2D.h, Engine/TextureCube.h; here an object stands for the asset's path
// (SettingObjects.h).
#pragma once

#include "CoreMinimal.h"
#include "Engine/TextureDefines.h"
#include "PixelFormat.h"
#include "UObject/Object.h"

class FTextureResource; // TextureResource.h
struct FTexturePlatformData;

class DRYDOCK_API UTexture : public UObject
{
public:
	DRYDOCK_CLASS(UTexture, UObject)
	using UObject::UObject;

	/** Null for an asset's name: no asset is loaded. */
	FTextureResource* GetResource() const { return Resource; }
	/** Not owned. */
	void SetResource(FTextureResource* InResource) { Resource = InResource; }

	/** Texels; 0 for an asset's name. */
	virtual float GetSurfaceWidth() const { return 0.0f; }
	virtual float GetSurfaceHeight() const { return 0.0f; }

	/** As older code names it. */
	FTextureResource* Resource = nullptr;

	/** Whether the bytes of an 8-bit picture are sRGB-encoded: shaders read linear light. */
	uint8 SRGB : 1 = 1;
	TextureFilter Filter = TF_Default;
	// These change nothing here: no picture is packed, and there is one mip.
	TextureCompressionSettings CompressionSettings = TC_Default;
	TextureMipGenSettings MipGenSettings = TMGS_FromTextureGroup;
	TextureGroup LODGroup = TEXTUREGROUP_World;
	bool NeverStream = false;
};

class DRYDOCK_API UTexture2D : public UTexture
{
public:
	DRYDOCK_CLASS(UTexture2D, UTexture)
	using UTexture::UTexture;

	/** A texture without an asset, its texels 0. Null for sizes below 1. */
	static UTexture2D* CreateTransient(
		int32 InSizeX, int32 InSizeY, EPixelFormat InFormat = PF_B8G8R8A8, FName InName = NAME_None);
	/** Makes the texture that shaders read of the bytes, and of the members as they are now. */
	void UpdateResource();
	/** The bytes; null for an asset's name. */
	FTexturePlatformData* GetPlatformData() const { return PlatformData.get(); }

	/** Texels; 0 for an asset's name. */
	int32 GetSizeX() const { return int32(GetSurfaceWidth()); }
	int32 GetSizeY() const { return int32(GetSurfaceHeight()); }
	float GetSurfaceWidth() const override;
	float GetSurfaceHeight() const override;

	TextureAddress AddressX = TA_Wrap;
	TextureAddress AddressY = TA_Wrap;

private:
	std::shared_ptr<FTexturePlatformData> PlatformData;
	std::shared_ptr<FTextureResource> OwnResource;
};

class DRYDOCK_API UTextureCube : public UTexture
{
public:
	DRYDOCK_CLASS(UTextureCube, UTexture)
	using UTexture::UTexture;
};
