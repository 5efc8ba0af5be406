// Provides the pixels of the textures that settings name. Settings hold identities (SettingObjects.h). The caller that
// runs a frame defines how a path becomes pixels, and passes ask for the pixels when they need them. In the engine the
// pixels are the texture's resource.
#pragma once

#include "Engine/Texture.h"
#include "RHIResources.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** Pixels for a path as settings write it; null: there are none. May throw FError. */
using FTextureLoader = std::function<FTextureRHIRef(const std::string& Path)>;

/** Loads textures while it lives; after it the one before it does again. */
class DRYDOCK_API FScopedTextureLoader : private FNoncopyable
{
public:
	explicit FScopedTextureLoader(FTextureLoader Loader);
	~FScopedTextureLoader();

private:
	FTextureLoader Previous;
};

/** Built-in pictures (BuiltinTextures.h) always; others through the loader. Each path is loaded once for a loader: the
 * same texture each time. Null: no texture, or no pixels for it. Throws what the loader throws. Any thread. */
DRYDOCK_API FTextureRHIRef FindTexturePixels(const UTexture* Texture);
DRYDOCK_API FTextureRHIRef FindTexturePixels(const std::string& Path);

/** PF_A32B32G32R32F, one mip; row-major, Size.X * Size.Y colours. */
DRYDOCK_API FTextureRHIRef MakePictureTexture(
	FIntPoint Size, const std::vector<FLinearColor>& Colors, const std::string& Name);

} // namespace Drydock
