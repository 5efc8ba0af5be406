// Textures as settings name them: an identity without pixels. Source: engine Engine/Texture.h, Engine/Texture2D.h,
// Engine/TextureCube.h; here an object stands for the asset's path (SettingObjects.h).
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class DRYDOCK_API UTexture : public UObject
{
};

class DRYDOCK_API UTexture2D : public UTexture
{
};

class DRYDOCK_API UTextureCube : public UTexture
{
};
