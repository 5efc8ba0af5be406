// Builds the bloom of the chain: the bloom setup where it is needed, and the sum of Gaussians or the convolution.
// Source: engine PostProcess/PostProcessing.cpp.
#pragma once

#include "Bloom/PostProcessToonBloom.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "PostProcess/PostProcessInputs.h"
#include "RenderGraphFwd.h"
#include "Screen/PostProcessDownsample.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

/** The inputs of bloom. */
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
	/** Not valid where it is off, or does not act on bloom. A convolution reads none, as in the engine. */
	Drydock::FLocalExposureTextures LocalExposure;
	/** The parameters of both, whether local exposure acts or not. */
	FEyeAdaptationParameters EyeAdaptationParameters;
	FLocalExposureParameters LocalExposureParameters;
	/** For the code of an engine overlay. */
	const FPostProcessingInputs* PostProcessing = nullptr;
	/** Set where toon bloom is active. */
	const Drydock::FToonBloomInputs* Toon = nullptr;
};

struct FBloomChainOutputs
{
	/** The bloom that the tonemapper adds: half resolution, or that of FFT bloom. */
	FScreenPassTexture Bloom;
	/** The factor by which FFT bloom multiplies the scene colour (PostProcessFFTBloom.h); null: 1. */
	FRDGBufferRef SceneColorApplyParameters = nullptr;
};

/** Adds bloom, by convolution where IsFFTBloomEnabled. Toon bloom then masks the picture at full resolution. */
FBloomChainOutputs AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs);
