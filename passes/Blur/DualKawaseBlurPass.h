// The dual Kawase blur: halve the image a few times, each time averaging 5 bilinear taps; then double it as often, each
// time averaging 8. Docs: docs/dual-kawase.md. Source: Bjorge, "Bandwidth-Efficient Rendering", SIGGRAPH 2015;
// parameters as in the article on view extensions that drydock was made for.
//
// Contract, corrected form (the default). The result has the input's extent, rect and format; so has every level its
// format and ceiling-divided rect size. Levels map 2:1 in texels from the rect's corner, so that nothing drifts at odd
// sizes. Every tap is clamped to half a texel inside the rect: nothing outside is read, and nothing outside the
// result's rect is written. An offset rect gives the bits of the cropped image. Weights sum to 1: a constant stays
// constant, bit for bit in formats of at most 16 bits per channel, within 1e-6 of itself with 32; a linear ramp stays a
// ramp away from the borders. The sum of an image is kept away from its borders at whole offsets; at others it is kept
// as the mean over positions. NaN and infinities spread over the reach (GetDualKawaseReach) and no further, and an
// infinity beside another of the other sign makes NaN; negatives pass on; the largest half, 65504, does not overflow.
// Images less than 3 pixels wide or high have no level and stay as they are.
//
// As printed (r.DualKawase.AsPrinted 1): see bAsPrinted. Rects, OverrideOutput and the sampler's rules above do not
// apply.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FDualKawaseBlurInputs
{
	/** [Required] What is blurred. */
	FScreenPassTexture SceneColor;

	/** [Optional] Written in place of a new texture; its rect is the output rect, to which the input's is scaled. */
	FScreenPassRenderTarget OverrideOutput;

	/** Distance of the taps in half texels of the coarser of two levels; finite. Acts in steps of 1/256. 1 is the
	 * published filter; above 2 blocks show (a remark on the graph). */
	float Offset = 1.0f;

	/** Number of halvings, 0 to 8; 0 and below: none. Fewer run, with a remark on the graph, where the shorter side
	 * would fall below 2. */
	int32 PassNum = 3;

	/** The article's own form, for comparison: the first pass down is not smaller than the image, sizes are halved and
	 * doubled truncating, so that rows and columns are lost (a remark on the graph gives their number); taps are half a
	 * pixel of each pass's output apart; a point sampler, clamped; the texture's extent for the rect; a UAV flag alone.
	 * OverrideOutput is not honoured. The article prints its C++ and only describes its taps: they are Bjorge's. */
	bool bAsPrinted = false;
};

/** r.DualKawase.AsPrinted. */
DRYDOCK_API bool IsDualKawaseAsPrinted();

/** The input itself where there is no level and no OverrideOutput. */
DRYDOCK_API FScreenPassTexture AddDualKawaseBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDualKawaseBlurInputs& Inputs);

} // namespace Drydock
