// Bloom as the chain has it: the bloom setup where something calls for it, and the blur. Source: engine
// PostProcess/PostProcessing.cpp.
#pragma once

#include "PostProcessDownsample.h"
#include "PostProcessToonBloom.h"
#include "RenderGraphFwd.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

/** What bloom is made of. */
struct FBloomChainInputs
{
	/** [Required] Linear, pre-exposed, full resolution. */
	FScreenPassTexture SceneColor;
	/** [Required] SceneColor, downsampled. */
	FScreenPassTexture HalfResolution;
	/** [Required] From HalfResolution down. */
	const FSceneDownsampleChain* SceneDownsampleChain = nullptr;
	/** [Required] (PostProcessEyeAdaptation.h) */
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	/** Set where toon bloom is active. */
	const FToonBloomInputs* Toon = nullptr;
};

/** Returns what the tonemapper adds, in half resolution. */
FScreenPassTexture AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs);
