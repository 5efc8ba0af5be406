// Bloom setup with toon bloom: the pass of PostProcessBloomSetup.h, in which toon pixels bloom with a strength of their
// own. Source: the article's engine patch, and its correction (drydock).
//
// Corrected: C of the result is that of the full-resolution colour whose toon pixels are multiplied by ToonIntensity,
// downsampled like the input; the ramp stays that of the unmasked input. Without a threshold the colour passes
// untouched, so a factor of 1 gives the bits of a frame without this pass. Texels that no toon pixel reaches have the
// same bits for every factor; the result is linear in the factor below the clamp. As printed (r.ToonBloom.AsPrinted):
// result * (shading model id at the input's UV is cloth ? ToonIntensity : 1), in the pixel shader only; the compute
// shader is then that of the bloom setup.
#pragma once

#include "Bloom/PostProcessBloomSetup.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Screen/PostProcessDownsample.h"

namespace Drydock
{

/** Toon.SceneColor: what Inputs.SceneColor was downsampled from, with that quality; where it is not given, the scene
 * textures' colour at the view's rect. With ToonBounds only what toon pixels reach is masked and downsampled anew, and
 * Inputs.SceneColor must be that picture itself, or its AddDownsamplePass. Toon.ToonIntensity: above -1. */
DRYDOCK_API FScreenPassTexture AddToonBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FBloomSetupInputs& Inputs, const FToonBloomInputs& Toon,
	EDownsampleQuality DownsampleQuality = EDownsampleQuality::Low);

} // namespace Drydock
