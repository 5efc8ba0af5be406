// Bloom setup: keeps what is bright enough to bloom. Source: engine file PostProcessBloomSetup.h; the inputs' members
// are those that public patches print.
//
// Formula, per pixel: C = scene colour / PreExposure, C = min(C, 65536), L = luminance(C) * exposure scale, amount =
// saturate((L - Threshold) / 2), or exactly 1 where Threshold <= -1 and the view's engine has no ramp then
// (EngineProfile.h); result (amount * C * PreExposure, 0). Local exposure multiplies C before the clamp. Contract. Same
// extent, rect and format as the input. NaN becomes 65536 * PreExposure before the ramp (min takes the other operand,
// as on a GPU), and so does +Inf; -Inf and negatives pass on until an unsigned store clips them. An input without such
// values gives none.
#pragma once

#include "Bloom/PostProcessGaussianBloom.h"
#include "CoreMinimal.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "ScreenPass.h"

struct FBloomSetupInputs
{
	/** [Required] */
	FScreenPassTexture SceneColor;

	/** [Required] Entry 0's x is the exposure scale. */
	FRDGBufferRef EyeAdaptationBuffer = nullptr;

	/** Threshold in exposed luminance; -1 and below: no threshold. -infinity and NaN: no threshold either, even in
	 * engines whose ramp acts at -1. */
	float Threshold = 0.0f;

	/** [Optional] The chain gives both, whether local exposure acts or not. */
	const FEyeAdaptationParameters* EyeAdaptationParameters = nullptr;
	const FLocalExposureParameters* LocalExposureParameters = nullptr;
	/** [Optional] The bilateral grid, and with it the luminance: local exposure acts. */
	FRDGTextureRef LocalExposureTexture = nullptr;
	FRDGTextureRef BlurredLogLuminanceTexture = nullptr;
};

namespace Drydock
{

// The engine's are in its .cpp, and an overlay's file defines them there.
struct FBloomSetupParameters;

/** The parameters that the pixel shader and the compute shader share. */
DRYDOCK_API FBloomSetupParameters GetBloomSetupParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTextureViewport& InputViewport, const FBloomSetupInputs& Inputs);

} // namespace Drydock

DRYDOCK_API FScreenPassTexture AddBloomSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs);
