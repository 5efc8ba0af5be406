// Weighted sums of bilinear taps over a tile: the whole work of blurs and downsamples. Rows of the source are decoded
// once into floats; then a tap is plain loads along a row, where the sampler would find, test and decode its texels
// again for every pixel and tap.
//
// Contract. Stored are the bits that the shader stores for which a sum stands: coordinates go through the shader's own
// float operations and the sampler's snapping, texels are mixed in the sampler's order (rows first, then columns), taps
// are added in the order given. A NaN is a NaN, of any payload. The same for every lane width, tiling and thread count.
// No standard header is included: the kernel's files are built for instruction sets that the linker must not mix up.
#pragma once

#include "ShaderKernel.h"

#include <cstddef>

namespace Drydock
{

/** How a shader makes a texture coordinate of pixel x, along one axis: its operations in its order.
 *
 *      v = (x + 0.5 - Origin) * Scale * Extent + First
 *      v = floor(v * Steps + 0.5) / Steps       where Steps is not 0
 *      UV = clamp((clamp(v, Min, Max) + Second) * ToUV, MinUV, MaxUV)
 *
 * A step that a shader lacks keeps its value of here, which changes nothing. */
struct FTapAxis
{
	float Origin = 0.0f;
	float Scale = 1.0f;
	float Extent = 1.0f;
	float First = 0.0f;
	float Steps = 0.0f;
	float Min = -__builtin_inff();
	float Max = __builtin_inff();
	float Second = 0.0f;
	float ToUV = 1.0f;
	float MinUV = -__builtin_inff();
	float MaxUV = __builtin_inff();
};

struct FTap
{
	FTapAxis X;
	FTapAxis Y;
	float Weight[4] = {1.0f, 1.0f, 1.0f, 1.0f};
};

/** The value of coordinates outside a source's rect. */
enum class EBeyondRect : uint8_t
{
	Sampler, // the rect is the whole texture, and the sampler knows
	Clamp,   // there are none: Min and Max or MinUV and MaxUV of the taps hold them in
	Black,   // 0 in all channels, mixed with the edge texels; Min and Max are the centres of those, Steps is 256
};

/** A texture and its taps. The rect is in texels, half-open, inside the texture. */
struct FTapSource
{
	const FKernelTexture* Texture = nullptr;
	const FKernelSampler* Sampler = nullptr;
	int32_t RectMin[2] = {0, 0};
	int32_t RectMax[2] = {0, 0};
	EBeyondRect Beyond = EBeyondRect::Sampler;
	/** The sum begins with 0 and not with the first tap: -0 becomes 0. */
	bool bFromZero = false;
	const FTap* Taps = nullptr;
	int32_t NumTaps = 0;
};

/** The sum of the first source's taps, plus those of the others; then multiplied, and, with bNoNegatives, red,
 * green and blue held at 0 and above, where NaN becomes 0. */
struct FTapSum
{
	const FTapSource* Sources = nullptr;
	int32_t NumSources = 0;
	float Factor = 1.0f;
	bool bNoNegatives = false;
};

/** Stores the sum for each pixel of the tile at that pixel plus ToTarget, all of it inside Target. False, with nothing
 * stored, where equal bits are not to be had: a sampler that is not bilinear or does not snap, mips, volumes, 64-bit
 * storage, integers, a black border with taps that do not move in step with the pixels. */
bool SumTaps(
	const FTapSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY);

/** Whether texels of this storage are floats of at most 32 bits in lanes. */
bool HasFloatLanes(ETexelStorage Storage);

/** Whether the shader's first target is stored as the shader gives it, and taps are not counted. */
bool StoresPlainly(const FKernelArgs& Args);

template<int N>
struct TTapSumLanes
{
	/** SumTaps on N lanes, for what it does not turn away at once. */
	[[gnu::weak]] static bool Run(const FTapSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile,
		int32_t ToTargetX, int32_t ToTargetY);
};

/** The calling thread's memory of that number (below 16), at least so many bytes, aligned to 64; its contents are lost
 * when it grows, and numbers otherwise. */
void* GetTapMemory(int32_t Number, size_t Bytes);

} // namespace Drydock
