// Builds the exposure and local exposure of the chain: metering, adaptation from last frame's buffer, the bilateral
// grid and the blurred luminance. Source: engine PostProcess/PostProcessing.cpp.
#pragma once

#include "Exposure/PostProcessEyeAdaptation.h"
#include "Screen/PostProcessDownsample.h"

class FRDGBuilder;
class FViewInfo;

/** The inputs of metered and local exposure. */
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
};

struct FExposureChainOutputs
{
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	/** Null where there is none. */
	FRDGTextureRef Histogram = nullptr;
	FEyeAdaptationParameters EyeAdaptationParameters;
	/** Not valid where it is off. */
	Drydock::FLocalExposureTextures LocalExposure;
};

/** The level of the downsample chain whose luminance local exposure blurs. */
constexpr uint32 GBlurredLogLuminanceLevel = 4;

/** Adapts from what View.ViewState has of the last frame, and keeps this frame's there. */
FExposureChainOutputs AddExposurePasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FExposureChainInputs& Inputs);
