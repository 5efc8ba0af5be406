// Tonemapping: exposure, vignette, bloom, the engine's film curve evaluated analytically, sRGB.
// Source: engine file PostProcessTonemap.h.
//
// Built so far: scene colour tint, vignette, local exposure, bloom composite, film curve with its five parameters, blue correction,
// gamut expansion, tone-curve amount, sRGB output. Not yet: colour grading and its lookup table, film
// grain, sharpening, chromatic aberration, dirt mask, other output devices, the gamma-only path.
//
// Per pixel: colour * tint * e * local exposure + bloom * e, e = exposure scale / PreExposure * vignette; then the
// curve in AP1.
// Contract. The result lies in 0..1 before an UNORM store for every input: after bloom a NaN or negative channel counts
// as 0, one above 65504 (infinity too) as 65504. Black gives black. Bloom is sampled bilinearly within its bilinear
// rect. Every size from 1x1 up. A float target keeps what the curve gives above 1 (white clip).
#pragma once

#include "CoreMinimal.h"
#include "PostProcessLocalExposure.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

struct FTonemapInputs
{
	/** [Optional] Written in place of a new texture; must have the size of SceneColor's rect. */
	FScreenPassRenderTarget OverrideOutput;

	/** [Required] Linear, pre-exposed. */
	FScreenPassTexture SceneColor;

	/** [Optional] Linear, pre-exposed, intensity applied; any resolution. */
	FScreenPassTexture Bloom;

	/** [Optional] Entry 0's rgb multiplies scene colour, not bloom (PostProcessFFTBloom.h); null: 1. The name is the
	 * engine's, letter for letter. */
	FRDGBufferRef SceneColorApplyParamaters = nullptr;

	/** [Required] Entry 0's x is the exposure scale. */
	FRDGBufferRef EyeAdaptationBuffer = nullptr;

	/** [Optional] Colour, not bloom, times its factor. */
	FLocalExposureTextures LocalExposure;

	/** Format of a new output. */
	EPixelFormat OutputFormat = PF_B8G8R8A8;

	/** Luma of the result into alpha (FXAA reads it), else 0. */
	bool bWriteAlphaChannel = false;
};

/** Settings (film, vignette, tint, corrections) come from View.FinalPostProcessSettings. */
DRYDOCK_API FScreenPassTexture AddTonemapPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs);

namespace Drydock
{

/** Viewport position (-1..1) to vignette space: the corner is at sqrt(2) for any aspect ratio. */
DRYDOCK_API FVector2f ComputeVignetteScale(FIntPoint ViewSize);

} // namespace Drydock
