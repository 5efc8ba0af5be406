// Kernels of convolution bloom out of image files: how a config's BloomConvolutionTexture becomes pixels.
// Source: drydock.
#pragma once

#include "BloomKernelTextures.h"
#include "Config.h"

namespace Drydock
{

/** A path with an image's extension is a file, relative to the config; colours are read as linear light (PNG is
 * decoded), a single channel as grey. Any other path names an engine asset and has no pixels. The loader throws FError
 * (exit code 3) for a file that is missing or broken. */
DRYDOCK_API FBloomKernelLoader MakeBloomKernelLoader(const FConfig& Config);

} // namespace Drydock
