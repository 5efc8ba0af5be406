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

/** False where the shader has to do it. */
bool MakeLocalExposureJob(const FNativeKernelArgs& Args, const FLocalExposureShaderParameters& Parameters,
	const float EyeAdaptation[4], float OneOverPreExposure, FLocalExposureJob& Out);

/** Whether a tile of pixels, which the viewport counts, lies inside the target. */
bool IsInsideTarget(const FKernelTexture* Target, const FKernelTile& Pixels);

} // namespace Drydock
