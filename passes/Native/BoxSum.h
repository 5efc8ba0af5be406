// Box means along rows or columns by sums that do not grow with the radius: prefix sums in registers along a row,
// running sums down columns.
//
// Contract. Sums are in double or, of bytes and of half floats from 0 to 1, in integers; they are rounded to float,
// then multiplied. So a mean is the shader's, which adds floats one by one, to within (2 Radius + 8) half units in the
// last place of the largest partial sum. Sums of values of at most 16 bits a channel are exact: the same bits for every
// lane width, tiling and thread count. Those of 32-bit floats begin anew every 16 rows and 256 columns, where tiles
// begin however many there are, and have the same bits too. No standard header is included: the kernel's files are
// built for instruction sets that the linker must not mix up.
#pragma once

#include "ShaderKernel.h"

namespace Drydock
{

/** Tiles begin and end at multiples of these rows and columns, however large they are (RHICommandList.cpp). */
constexpr int32_t GRowsOfBoxGroup = 16;
constexpr int32_t GColumnsOfBoxGroup = 256;

/** (the sum of 2 Radius + 1 texels + Fraction * (the next one on either side)) * Scale, to all channels but alpha,
 * which is 1. The rect is in texels, half-open, inside the texture; beyond it lies the edge texel. */
struct FBoxSum
{
	const FKernelTexture* Source = nullptr;
	int32_t Channel = 0;
	int32_t RectMin[2] = {0, 0};
	int32_t RectMax[2] = {0, 0};
	int32_t Axis = 0;
	int32_t Radius = 0;
	float Fraction = 0.0f;
	float Scale = 1.0f;
};

template<int N>
struct TBoxSumLanes
{
	/** Pixels: of the target, inside it; each stands for the source's texel ToSource further on. Formats: floats of at
	 * most 32 bits. Returns, as bits, the groups of GRowsOfBoxGroup rows that are left to the shader: they read values
	 * that are not finite, which would spoil the sums beside them. At most 64 groups. */
	[[gnu::weak]] static uint64_t Run(const FBoxSum& Sum, const FKernelTexture& Target, const FKernelTile& Pixels,
		int32_t ToSourceX, int32_t ToSourceY);
};

} // namespace Drydock
