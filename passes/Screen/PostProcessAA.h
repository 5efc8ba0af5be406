// FXAA: finds edges by luma and blends along them, in one pass over the display-encoded picture. Source: engine file
// PostProcessAA.h; algorithm and presets: T. Lottes, FXAA 3.11 (NVIDIA, 2011).
//
// Contract. A pixel whose neighbourhood's lumas differ by less than the threshold comes through bit for bit. Others get
// one bilinear tap, so that no channel leaves the range of the neighbours (quality 0: a mean of up to four). Reads
// nothing outside the input's rect, whose edge is repeated; the same bits wherever the rect lies. Every size from 1x1
// up; NaN and infinities reach no further than the search along an edge, 24 texels; negatives pass on. Alpha of the
// result is 0.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

/** Q0: four taps across the edge (the console variant). From Q1 on the edge is searched in both directions, in so many
 * steps: 3, 5, 8, 12, 12 (the first ones one texel each). */
enum class EFXAAQuality : uint32
{
	Q0,
	Q1,
	Q2,
	Q3,
	Q4,
	Q5,
	MAX
};

/** r.FXAA.Quality, 4 by default. */
DRYDOCK_API EFXAAQuality GetFXAAQuality();

struct FFXAAInputs
{
	/** [Optional] Written in place of a new texture; must have the size of SceneColor's rect. */
	FScreenPassRenderTarget OverrideOutput;

	/** [Required] Display-encoded. */
	FScreenPassTexture SceneColor;

	EFXAAQuality Quality = EFXAAQuality::Q4;

	/** SceneColor's alpha is its luma, as the tonemapper writes it; else luma is computed from the colour. */
	bool bLumaInAlpha = true;
};

DRYDOCK_API FScreenPassTexture AddFXAAPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFXAAInputs& Inputs);
