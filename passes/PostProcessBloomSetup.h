// Bloom setup: keeps what is bright enough to bloom. Source: engine file PostProcessBloomSetup.h.
//
// Formula, per pixel: C = scene colour / PreExposure, C = min(C, 65536), L = luminance(C) * exposure scale,
// amount = saturate((L - Threshold) / 2), or exactly 1 where Threshold <= -1; result (amount * C * PreExposure, 0).
// Contract. Same extent, rect and format as the input. NaN becomes 65536 * PreExposure before the ramp (min takes the
// other operand, as on a GPU), +Inf likewise; -Inf and negatives pass on until an unsigned store clips them. An input
// without such values gives none.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessDownsample.h"
#include "PostProcessGaussianBloom.h"
#include "ScreenPass.h"

struct FBloomSetupInputs
{
	/** [Required] */
	FScreenPassTexture SceneColor;
	/** [Required] Entry 0's x is the exposure scale. */
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	/** In exposed luminance; -1 and below: no threshold. */
	float Threshold = -1.0f;
};

DRYDOCK_API FScreenPassTexture AddBloomSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs);
