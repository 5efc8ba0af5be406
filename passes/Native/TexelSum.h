// Weighted sums of whole texels along one axis, symmetric about the middle one: a Gaussian's rows or columns. Rows are
// decoded once a tile; the taps are then loads, products and sums of registers.
//
// Contract. Stored are the bits that DualKawaseBlur.usf's Gaussian stores: each tap's product is rounded, taps are
// added from the lowest index up. A NaN is a NaN, of any payload. The same for every lane width, tiling and thread
// count. No standard header is included: the kernel's files are built for instruction sets that the linker must not mix
// up.
#pragma once

#include "ShaderKernel.h"

namespace Drydock
{

/** The rect is in texels, half-open, inside the texture; beyond it lies the edge texel. */
struct FTexelSum
{
	const FKernelTexture* Source = nullptr;
	int32_t RectMin[2] = {0, 0};
	int32_t RectMax[2] = {0, 0};
	int32_t Axis = 0;
	/** Weights of the texels at distance 0, 1, ..., Reach. */
	const float* Weights = nullptr;
	int32_t Reach = 0;
};

template<int N>
struct TTexelSumLanes
{
	/** Pixels: of the target, inside it; each stands for the source's texel ToSource further on. Formats: floats of at
	 *  most 32 bits. */
	[[gnu::weak]] static void Run(const FTexelSum& Sum, const FKernelTexture& Target, const FKernelTile& Pixels,
		int32_t ToSourceX, int32_t ToSourceY);
};

} // namespace Drydock
