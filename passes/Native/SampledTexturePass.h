// Connects screen passes with lanes code that samples: viewports, textures and local exposure from a pass's parameters.
#pragma once

#include "BoundShader.h"
#include "CoreMinimal.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Native/LocalExposureLanes.h"
#include "SceneView.h"
#include "ScreenPass.h"

namespace Drydock
{

/** Positions of a viewport's pixels. */
void SetViewport(const FScreenPassTextureViewportParameters& Viewport, FViewportAxis Out[2]);

/** The texture and sampler of those names, sampled over a viewport within its bilinear bounds. */
FSampledTexture MakeSampledTexture(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler,
	const FScreenPassTextureViewportParameters& Viewport);

/** Entry 0 of the eye-adaptation buffer; zeros where there is none. */
void ReadEyeAdaptation(const FNativeKernelArgs& Args, const char* Buffer, float Out[4]);

/** View.OneOverPreExposure of a pass. */
float GetOneOverPreExposure(const TUniformBufferRef<FViewUniformShaderParameters>& View);

/** The texture and sampler of those names, sampled at positions of the view as the sampler clamps them. */
FSampledTexture MakeUnheldTexture(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler);

/** Its textures have the names LumBilateralGrid and BlurredLogLum. False where the shader has to do it. */
bool MakeLocalExposureJob(const FNativeKernelArgs& Args, const FLocalExposureParameters& Parameters,
	const FEyeAdaptationParameters& EyeAdaptation, const float EyeAdaptationEntry[4], float OneOverPreExposure,
	FLocalExposureJob& Out);

/** Parameters: of a pass that has both structs. */
template<typename FPassParameters>
bool MakeLocalExposureJob(const FNativeKernelArgs& Args, const FPassParameters& Parameters,
	const float EyeAdaptationEntry[4], float OneOverPreExposure, FLocalExposureJob& Out)
{
	return MakeLocalExposureJob(
		Args, Parameters.LocalExposure, Parameters.EyeAdaptation, EyeAdaptationEntry, OneOverPreExposure, Out);
}

/** Whether a tile of pixels, which the viewport counts, lies inside the target. */
bool IsInsideTarget(const FKernelTexture* Target, const FKernelTile& Pixels);

} // namespace Drydock
