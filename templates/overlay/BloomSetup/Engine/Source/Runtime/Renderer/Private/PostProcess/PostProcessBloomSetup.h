// The inputs of the bloom setup, in the form of the engine's file of this name.
#pragma once

#include "PostProcess/PostProcessEyeAdaptation.h"
#include "PostProcess/PostProcessLocalExposure.h"
#include "ScreenPass.h"

struct FBloomSetupInputs
{
	// [Required] The picture, linear and pre-exposed.
	FScreenPassTexture SceneColor;

	// [Required] Entry 0 holds the exposure scale.
	FRDGBufferRef EyeAdaptationBuffer = nullptr;

	// Brightness from which pixels bloom, in exposed luminance.
	float Threshold = 0.0f;

	// The parameters of eye adaptation and local exposure.
	const FEyeAdaptationParameters* EyeAdaptationParameters = nullptr;
	const FLocalExposureParameters* LocalExposureParameters = nullptr;

	// [Optional] The bilateral grid and the blurred luminance; null without local exposure.
	FRDGTextureRef LocalExposureTexture = nullptr;
	FRDGTextureRef BlurredLogLuminanceTexture = nullptr;
};

FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs);
