// The histogram of a picture's log2 luminance, from which exposure is metered. Source: engine file
// PostProcessHistogram.h.
//
// On the CPU, with the engine's bucket maths: the engine's shader counts with atomics in group-shared memory, which the
// shader tier does not have. A texel is shared between the two buckets that its log2 luminance lies between; bucket i
// stands for position i / 63 of the range. Sums are taken in double, over strips of rows in their order: the same bits
// for any number of threads. Contract. Buckets hold shares of the rect's texels, times the mask: without one they sum
// to 1, less what the lowest bucket loses (black) and less NaN, which is left out. Negatives count as black, infinity
// as 65536. Any size from 1x1 up; nothing outside the rect is read.
#pragma once

#include "CoreMinimal.h"
#include "Exposure/PostProcessEyeAdaptationParameters.h"
#include "ScreenPass.h"

#include <array>

/** PF_A32B32G32R32F, 16 x 1: four buckets to a texel, the darkest first. SceneColor: linear, pre-exposed. MeterMask:
 * weights over the view in its red, sampled bilinearly; null: all alike. */
DRYDOCK_API FRDGTextureRef AddHistogramPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask = nullptr);

namespace Drydock
{

constexpr int32 GHistogramSize = 64; // buckets

/** The histogram that AddHistogramPass wrote. */
DRYDOCK_API std::array<double, GHistogramSize> ReadHistogram(FRHITexture& Texture);

} // namespace Drydock
