// Exposure and local exposure as the chain has them: metering, adaptation from last frame's buffer, the bilateral grid
// and the blurred luminance. Source: engine PostProcess/PostProcessing.cpp.
#pragma once

#include "PostProcessDownsample.h"
#include "PostProcessEyeAdaptation.h"
#include "RenderGraphResourcePool.h"

class FRDGBuilder;
class FViewInfo;

/** What both are made of. */
struct FExposureChainInputs
{
	/** The picture, downsampled, and from there down; may be missing where nothing is metered and bLocalExposure is
	 * off.
	 */
	FScreenPassTexture HalfResolution;
	const FSceneDownsampleChain* SceneDownsampleChain = nullptr;
	/** Exposure by the settings; else ExposureScale holds. */
	bool bAutoExposure = false;
	float ExposureScale = 1.0f;
	bool bLocalExposure = false;
	/** Last frame's buffer, null inside if there was none, and where this frame's is kept; null: nothing is kept. */
	TRefCountPtr<FRDGPooledBuffer>* EyeAdaptation = nullptr;
};

struct FExposureChainOutputs
{
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	/** Null where there is none. */
	FRDGTextureRef Histogram = nullptr;
	/** Not valid where it is off. */
	FLocalExposureTextures LocalExposure;
};

/** The level of the downsample chain whose luminance local exposure blurs. */
constexpr uint32 GBlurredLogLuminanceLevel = 4;

FExposureChainOutputs AddExposurePasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FExposureChainInputs& Inputs);
