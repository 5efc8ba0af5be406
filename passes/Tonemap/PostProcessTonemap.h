// Tonemapping: fringe, vignette, exposure, sharpening, bloom, dirt, grain, then the film curve with colour grading and
// the output device's encoding. Source: engine file PostProcessTonemap.h.
//
// Per pixel: colour * tint * e * local exposure + bloom * dirt * e, e = exposure scale / PreExposure * vignette; times
// grain; then the curve in AP1; r.Tonemapper.GrainQuantization then dithers what is rounded to 8 or 10 bits. Each part
// that its settings switch off is a permutation without it. Curve and grading come from the combined table, or, without
// ColorGradingTexture, are evaluated for each pixel (PostProcessCombineLUTs.h gives the difference). Contract. The
// result is finite and not negative for every input: after bloom a NaN or negative channel counts as 0, one above 65504
// (infinity too) as 65504. Black gives black unless grading lifts it. Bloom is sampled bilinearly within its bilinear
// rect. Every size from 1x1 up. A float target keeps what the curve gives above 1 (white clip). Gamma only: the power 1
// / display gamma of colour * e without vignette, nothing else; NaN and negative channels count as 0, and nothing is
// cut off above.
#pragma once

#include "CoreMinimal.h"
#include "Exposure/PostProcessLocalExposure.h"
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

	/** [Optional] Local exposure, by which colour is multiplied and bloom is not: all four, or none. */
	const FEyeAdaptationParameters* EyeAdaptationParameters = nullptr;
	const FLocalExposureParameters* LocalExposureParameters = nullptr;
	/** The bilateral grid. */
	FRDGTextureRef LocalExposureTexture = nullptr;
	FRDGTextureRef BlurredLogLuminanceTexture = nullptr;

	/** [Optional] The combined table (AddCombineLUTPass) of this view. */
	FRDGTextureRef ColorGradingTexture = nullptr;

	/** Show flags Tonemapper or PostProcessing are off. */
	bool bGammaOnly = false;

	/** Format of a new output. */
	EPixelFormat OutputFormat = PF_B8G8R8A8;

	/** Luma of the result into alpha (FXAA reads it), else 0. */
	bool bWriteAlphaChannel = false;
};

/** Settings come from View.FinalPostProcessSettings, the device from r.HDR.Display.OutputDevice. */
DRYDOCK_API FScreenPassTexture AddTonemapPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs);
