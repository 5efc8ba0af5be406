// Spatial upscale: the picture at another size, at the end of the chain, on display-encoded colours. Source: engine
// file PostProcessUpscale.h (numbers of r.Upscale.Quality and what they stand for; Directional and Gaussian are
// drydock's filters of that description, not the engine's kernels).
//
// Contract. Weights sum to 1: a flat picture stays flat. Nothing is read outside the input's rect, whose edge is
// repeated; the same bits wherever the rect lies. Nearest and bilinear: negatives, NaN and infinities pass on over the
// filter's footprint. The others: results are not negative, so what is below 0 and NaN become 0; an infinity makes
// infinity or 0 of its footprint; what passes 1 is cut off by the store. Every size from 1x1 up.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

enum class EUpscaleMethod : uint32
{
	Nearest,
	Bilinear,
	Directional, // two taps along the edge's direction, less a blur
	CatmullRom,  // bicubic in five bilinear taps, corners left out
	Lanczos,     // three lobes, 36 texels
	Gaussian,    // a narrow Gaussian, sharpened by a wide one, 36 texels
	MAX
};

/** r.Upscale.Quality: Nearest 0 to Gaussian 5; 3 by default. */
DRYDOCK_API EUpscaleMethod GetUpscaleMethod();

struct FUpscaleInputs
{
	/** [Optional] Written in place of a new texture. */
	FScreenPassRenderTarget OverrideOutput;

	/** [Required] Display-encoded. */
	FScreenPassTexture SceneColor;

	/** Size of a new texture; its rect begins at the origin. */
	FIntPoint OutputSize = FIntPoint(0, 0);

	EUpscaleMethod Method = EUpscaleMethod::CatmullRom;
};

/** Scales SceneColor's rect to that of the output; also to a smaller one. */
DRYDOCK_API FScreenPassTexture AddUpscalePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUpscaleInputs& Inputs);
