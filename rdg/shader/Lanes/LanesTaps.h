// Taps: places of a sample or load that a kernel remembers over one tile. The sample's column depends on the pixel's
// column alone, its row on the pixel's row. The library finds the texels' places at one pack; other packs with the same
// layout read from there: whole texels of floats or halves by the kernel itself (LanesTapReads.h), all others by a
// function of the library.
#pragma once

#include <cstdint>

namespace Drydock::Lanes
{

/** Texels that kernels read and write by themselves. */
enum class EWholeTexels : uint8_t
{
	None,
	Float, // RGBA32_FLOAT
	Half   // RGBA16_FLOAT
};

/** Columns are known for pixels [Begin, Begin + Length), rows for row Row. If both are known, the texels of the pack at
 * X begin Column + X * Stride bytes into Row0. */
struct FKernelTap
{
	int32_t Begin;
	uint32_t Length;
	int32_t Row;
	int32_t Stride;
	const uint8_t* Row0;
	const uint8_t* Row1; // null: WeightY is 0
	int64_t Column;
	float WeightX;
	float WeightY;
	/** Writes [4][N]. False where the sampler must decide, for NaNs. */
	bool (*Function)(const FKernelTap& Tap, int32_t X, float* Out);
	EWholeTexels Kind; // lane i is the texel at Row0 + i; None: Function must be called
};

} // namespace Drydock::Lanes
