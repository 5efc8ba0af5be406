// Pictures that settings name beside bloom kernels (lens dirt, colour grading tables): the same loader reads them.
// Source: drydock.
#pragma once

#include "BloomKernelTextures.h"

namespace Drydock
{

/** Linear light. Null: no texture, or no pixels for its path. Throws what the loader throws. */
inline FTextureRHIRef FindPictureTexture(const UTexture* Texture)
{
	return Texture != nullptr ? FindBloomKernelTexture(Texture) : FTextureRHIRef();
}

} // namespace Drydock
