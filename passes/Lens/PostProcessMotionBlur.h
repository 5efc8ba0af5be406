// Motion blur: each point's light spread along its movement during the exposure. Source: engine file
// PostProcessMotionBlur.h (names, passes, settings); the filter is drydock's own, after McGuire et al., "A
// Reconstruction Filter for Plausible Motion Blur" (2012).
//
// VelocityFlatten: movement in pixels and depth of each pixel. Length = velocity * MotionBlurAmount * (frame time of
// MotionBlurTargetFPS / actual frame time), at most MotionBlurMax percent of the view's width; centred on the pixel.
// VelocityTileMax, VelocityNeighborMax: the longest movement in a tile of 16 x 16, then in all tiles that can reach it.
// MotionBlurFilter, per pixel X with the longest movement V that can reach it, samples Y_i at spacing s along V:
//   a_i = s / max(|v_i|, 1)  where Y_i is not behind X and reaches it (|X - Y_i| <= |v_i| / 2), else 0
//   A = sum a_i;  result = (sum a_i c_i + max(1 - A, 0) * B) / max(A, 1)
//   B = what X shows when nothing passes over it: c_X, or, the more X itself moves, the mean of samples that do not
//       reach it
// so that light of a thing that moves over a still background is neither gained nor lost, but for the sampling.
//
// Contract. The picture is unchanged bit for bit where nothing within reach moves by half a pixel. A constant stays
// constant. Every result is a mix of input colours: NaN, infinities and negatives go where the samples that hold them
// go, and nowhere else. Velocities that are not finite count as 0. Nothing outside the rect is read. Any size from 1x1.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

/** r.MotionBlurQuality: 0 off, 1 to 4. */
enum class EMotionBlurQuality : uint32
{
	Off,
	Low,
	Medium,
	High,
	VeryHigh,
	MAX
};

DRYDOCK_API EMotionBlurQuality GetMotionBlurQuality();

struct FMotionBlurInputs
{
	/** [Optional] Written in place of a new texture. */
	FScreenPassRenderTarget OverrideOutput;
	/** [Required] */
	FScreenPassTexture SceneColor;
	/** [Required] Velocity and depth are read at the places of SceneColor's rect. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	EMotionBlurQuality Quality = EMotionBlurQuality::VeryHigh;
	/** Blur length for a velocity of one pixel per frame; 0 and below: no pass. */
	float VelocityScale = 0.0f;
	/** Longest blur, pixels; above 0. More than twice the picture's width and height together counts as that (DD2110).
	 */
	float MaxLength = 0.0f;

	/** Makes the inputs from MotionBlurAmount, Max and TargetFPS; DeltaTime: of the frame, seconds; 0: that of the
	 * target. */
	DRYDOCK_API static FMotionBlurInputs FromSettings(
		const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor, float DeltaTime);
};

/** SceneColor itself where there is nothing to do (then OverrideOutput is not written). */
DRYDOCK_API FScreenPassTexture AddMotionBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FMotionBlurInputs& Inputs);
