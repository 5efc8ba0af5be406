// Samples textures for the native kernels of screen shaders: u depends on a pixel's column alone, v on its row alone.
// Places and weights are found once for a tile. No standard header is included: the kernels' files are built for
// instruction sets that the linker must not mix up.
#pragma once

#include "ShaderKernel.h"

namespace Drydock
{

/** Positions of pixels in a viewport, 0 to 1, on one axis: (pixel + 0.5 - Origin) * Inverse. */
struct FViewportAxis
{
	float Origin = 0.0f;
	float Inverse = 1.0f;
};

/** Coordinates of those positions in a texture: clamp(position * Size + First, Min, Max). */
struct FSampledAxis
{
	float Size = 1.0f;
	float First = 0.0f;
	float Min = 0.0f;
	float Max = 1.0f;
};

struct FSampledTexture
{
	const FKernelTexture* Texture = nullptr;
	const FKernelSampler* Sampler = nullptr;
	FSampledAxis Axes[2];
};

/** Lanes code can sample it with the sampler's bits: bilinear and snapped, 2D, one mip, floats of at most 32 bits. */
bool CanSampleInLanes(const FKernelTexture* Texture, const FKernelSampler* Sampler);

} // namespace Drydock
