// Blurs along one axis of a picture of floats, in lanes: as many lines as there are lanes side by side, their four
// channels too, so that a filter that goes from texel to texel runs on whole vectors. In place; a line's result does
// not depend on the lines beside it, so lane widths agree bit for bit.
// No standard header is included but those of types: the kernel's files are built for instruction sets that the linker
// must not mix up.
#pragma once

#include <cstddef>
#include <cstdint>

namespace Drydock
{

/** Texel I of line L is four floats at Data + I * TexelStep + L * LineStep. At least one texel, one line. */
struct FBlurLines
{
	float* Data = nullptr;
	size_t TexelStep = 0;
	size_t LineStep = 0;
	int32_t Length = 0;
	int32_t NumLines = 0;
};

/** The average of 2 Radius + 1 texels and, with EndWeight, of the next one to each side; Scale is one over all weights.
 */
struct FBlurBox
{
	int32_t Radius = 0;
	float EndWeight = 0.0f;
	float Scale = 1.0f;
};

/** A section of first order and one of second, written in differences, so that an input that stays leaves them as they
 * are, whatever their coefficients are rounded to:
 *
 *      Real += First * (x - Real)
 *      Step += Second * (Real - Pair) - Damping * Step
 *      Pair += Step
 */
struct FBlurRecursion
{
	float First = 1.0f;
	float Second = 1.0f;
	float Damping = 1.0f;
	/** (Real, Pair, Step) of the way back beyond the end of a line from those of the way there at its end, both as
	 * differences from the constant that lies beyond. */
	float Turn[3][3] = {};
};

template<int N>
struct TBlurLanes
{
	/** Lines that run side by side. */
	static constexpr int32_t NumLines = N;

	/** At most NumLines lines. Scratch: GetBlurScratchFloats(Lines.Length) floats, aligned to 64 bytes. */
	[[gnu::weak]] static void AverageThrice(const FBlurLines& Lines, const FBlurBox& Box, float* Scratch);
	[[gnu::weak]] static void Recurse(const FBlurLines& Lines, const FBlurRecursion& Recursion, float* Scratch);
};

/** Scratch floats for the widest lanes: two copies of the lines, and the sums of a window's texels. */
constexpr size_t GetBlurScratchFloats(int32_t Length)
{
	return static_cast<size_t>(Length) * 3 * 4 * 16;
}

} // namespace Drydock
