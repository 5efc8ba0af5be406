// Bloom setup: keeps what is bright enough to bloom. Source: engine file PostProcessBloomSetup.h; toon bloom: the
// article's patch of it.
//
// Formula, per pixel: C = scene colour / PreExposure, C = min(C, 65536), L = luminance(C) * exposure scale, amount =
// saturate((L - Threshold) / 2), or exactly 1 where Threshold <= -1 and the view's engine has no ramp then
// (EngineProfile.h); result (amount * C * PreExposure, 0). Local exposure multiplies C before the clamp. Contract. Same
// extent, rect and format as the input. NaN becomes 65536 * PreExposure before the ramp (min takes the other operand,
// as on a GPU), and so does +Inf; -Inf and negatives pass on until an unsigned store clips them. An input without such
// values gives none.
//
// Toon bloom (Toon given). Corrected: C of the result is that of the full-resolution colour whose toon pixels
// are multiplied by ToonIntensity, downsampled like the input; the ramp stays that of the unmasked input. Without a
// threshold the colour passes untouched, so a factor of 1 gives the bits of a frame without this pass. Texels that no
// toon pixel reaches have the same bits for every factor; the result is linear in the factor below the clamp. As
// printed (r.ToonBloom.AsPrinted): result * (shading model id at the input's UV is cloth ? ToonIntensity : 1), in the
// pixel shader only.
#pragma once

#include "Bloom/PostProcessGaussianBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "CoreMinimal.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "SceneTextureParameters.h"
#include "Screen/PostProcessDownsample.h"
#include "ScreenPass.h"

struct FBloomSetupInputs
{
	/** [Required] */
	FScreenPassTexture SceneColor;
	/** [Required] Entry 0's x is the exposure scale. */
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	/** Threshold in exposed luminance; -1 and below: no threshold. -infinity and NaN: no threshold either, even in
	 * engines whose ramp acts at -1. */
	float Threshold = -1.0f;
	/** Not valid: none. */
	Drydock::FLocalExposureTextures LocalExposure;

	/** [Optional] Toon bloom. Its SceneColor: what SceneColor was downsampled from; where it is not given, the scene
	 * textures' colour at the view's rect. With ToonBounds only what toon pixels reach is masked and downsampled anew,
	 * and SceneColor must be that picture itself, or its AddDownsamplePass. */
	std::optional<Drydock::FToonBloomInputs> Toon;
	/** The quality that SceneColor was downsampled with. */
	EDownsampleQuality DownsampleQuality = EDownsampleQuality::Low;
};

DRYDOCK_API FScreenPassTexture AddBloomSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs);
