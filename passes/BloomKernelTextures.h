// The pixels of convolution bloom's kernels. Settings hold identities (SettingObjects.h); who runs a frame says how a
// path becomes pixels, and the bloom asks for them when it needs them. Source: drydock; in the engine they are the
// texture's resource.
#pragma once

#include "Engine/Texture.h"
#include "RHIResources.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** Pixels for a path as settings write it; null: there are none. May throw FError. */
using FBloomKernelLoader = std::function<FTextureRHIRef(const std::string& Path)>;

/** Loads kernels while it lives; then the one before it does. */
class DRYDOCK_API FScopedBloomKernelLoader
{
public:
	explicit FScopedBloomKernelLoader(FBloomKernelLoader Loader);
	~FScopedBloomKernelLoader();
	FScopedBloomKernelLoader(const FScopedBloomKernelLoader&) = delete;
	FScopedBloomKernelLoader& operator=(const FScopedBloomKernelLoader&) = delete;

private:
	FBloomKernelLoader Previous;
};

/** Null stands for "Builtin/Airy". Built-in kernels (BuiltinTextures.h) need no loader. Each path is loaded once for a
 * loader: the same texture each time. Null: there are no pixels. Throws what the loader throws. Any thread. */
DRYDOCK_API FTextureRHIRef FindBloomKernelTexture(const UTexture* Kernel);

/** PF_A32B32G32R32F, one mip; row-major, Size.X * Size.Y colours. */
DRYDOCK_API FTextureRHIRef MakeBloomKernelTexture(
	FIntPoint Size, const std::vector<FLinearColor>& Colors, const std::string& Name);

} // namespace Drydock
