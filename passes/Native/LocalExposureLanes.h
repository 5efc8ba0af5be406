// Applies local exposure in the native kernels of passes, as PostProcessLocalExposureCommon.ush does.
#pragma once

#include "Native/SampledTexture.h"

namespace Drydock
{

struct FLocalExposureJob
{
	FSampledTexture Blurred;
	/** x the sum of log2 luminance, y the weight; RG32F. */
	const FKernelTexture* Grid = nullptr;
	float GridScale[2] = {};
	float HighlightContrastScale = 1.0f;
	float ShadowContrastScale = 1.0f;
	float HighlightThreshold = 0.0f;
	float ShadowThreshold = 0.0f;
	float DetailStrength = 1.0f;
	float BlurredLuminanceBlend = 0.0f;
	float MiddleGreyExposureCompensation = 1.0f;
	float HistogramScale = 0.0f;
	float HistogramBias = 0.0f;
	float LuminanceMin = 0.0f;
	float OneOverPreExposure = 1.0f;
	float EyeAdaptation[4] = {};
};

} // namespace Drydock
