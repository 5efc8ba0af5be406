// RED depth of field: one blur for what lies before the focus and one for what lies behind it, mixed by depth.
// Source: article "RED post process" (custom DOF); drydock's decisions where it is silent.
//
//   far  = saturate((depth - FocalDistance - FocalRegion) / FarTransition)
//   near = saturate((FocalDistance - depth) / NearTransition)
//   result = lerp(lerp(c, farBlur, far), nearBlur, near)
// Depths in cm along the view's axis; both blurs run over rows, then columns, at half resolution.
//
// Contract. FocalDistance 0 and below, or NaN: no pass. The picture is unchanged bit for bit where near and far are 0.
// A transition of 0 is a step. Nothing outside the rects is read. Corrected: Gaussians; a constant picture stays
// constant to the edge; the far layer is weighted by far before it is blurred and divided by the blurred weight after,
// so that it does not gather pixels that are in focus; where nothing far is near, it is the picture itself. As printed
// (r.RED.AsPrinted 1): the article's loop of 13 taps over its table by distance, a sixth of the kernel's radius apart,
// which multiplies the light of a layer by 1.9952 a pass, 3.98 in all; the far layer takes the whole picture, and what
// is in focus bleeds outwards. NaN and infinities spread over the kernel, to what is out of focus only; negatives pass
// on. Any size from 1x1.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FREDDepthOfFieldInputs
{
	FScreenPassTexture SceneColor;
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	FScreenPassRenderTarget OverrideOutput;
	float FocalDistance = 0.0f;
	float FocalRegion = 0.0f;
	float NearTransition = 300.0f;
	float FarTransition = 500.0f;
	/** Diameter of the kernel in percent of the view's width. */
	float NearBlurSize = 1.0f;
	float FarBlurSize = 1.0f;
	bool bAsPrinted = false;

	/** Makes the inputs from the settings and r.RED.AsPrinted. */
	DRYDOCK_API static FREDDepthOfFieldInputs FromSettings(
		const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor);
};

/** SceneColor itself where there is no focus (then OverrideOutput is not written). */
DRYDOCK_API FScreenPassTexture AddREDDepthOfFieldPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDDepthOfFieldInputs& Inputs);

} // namespace Drydock
