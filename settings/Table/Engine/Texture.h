// Textures as settings name them: an identity without pixels, unless code gives it some. Source: engine
// Engine/Texture.h, Engine/Texture2D.h, Engine/TextureCube.h; here an object stands for the asset's path
// (SettingObjects.h).
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class FTextureResource; // TextureResource.h

class DRYDOCK_API UTexture : public UObject
{
public:
	using Super = UTexture;
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
};

class DRYDOCK_API UTexture2D : public UTexture
{
public:
	using Super = UTexture2D;
	using UTexture::UTexture;

	/** Texels; 0 for an asset's name. */
	int32 GetSizeX() const { return int32(GetSurfaceWidth()); }
	int32 GetSizeY() const { return int32(GetSurfaceHeight()); }
};

class DRYDOCK_API UTextureCube : public UTexture
{
public:
	using Super = UTextureCube;
	using UTexture::UTexture;
};
