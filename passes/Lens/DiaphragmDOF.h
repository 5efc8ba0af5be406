// Depth of field: a simplification of the engine's diaphragm depth of field. Source: engine file
// PostProcess/DiaphragmDOF.h (lens, limits, order of passes); the gather is drydock's own.
//
// Radius of the circle of confusion of a depth d, thin lens, in pixels of the view's width W:
//   f = SensorWidth / 2 * cot(half field of view),  A = f / Fstop
//   r(d) = A * f / (FocalDistance - f) * (d - FocalDistance) / d / SensorWidth * W / 2
// positive behind the focus, negative before it; at most r.DOF.Kernel.MaxBackgroundRadius and MaxForegroundRadius. The
// blur of the air (DepthOfFieldDepthBlur*): behind the focus at least Radius * W / 1920 * (1 - 2^(-d / Amount)).
//
// DOF Setup: half size, colour and radius. DOF TileMax, NeighborMax: the largest radius that can reach a tile of 16
// x 16. DOF Gather: behind the focus a pixel is the mean of what reaches it, where nothing reaches over what is nearer
// than itself; before the focus everything that reaches it covers it. DOF Recombine: full size, mixed by the radius.
// What the engine has and this has not: the shape of the aperture (a disc here), scattered highlights, the slight
// out-of-focus pass, squeeze, Petzval, temporal accumulation. Samples lie on a grid of at most 17 x 17: above 16 pixels
// of radius they are farther apart than pixels, and a single bright pixel shows the grid.
//
// Contract. Where no radius of half a pixel reaches, the picture is unchanged bit for bit. A constant stays constant.
// Every result is a mix of input colours. A depth that is not finite or not above 0 counts as in focus. FocalDistance
// or Fstop 0 and below: no pass. NaN, infinities and negatives go where the pixels that hold them go, and nowhere else:
// what is in focus keeps its bits. Nothing outside the rect is read. Any size from 1x1.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace DiaphragmDOF
{

/** The lens, in the terms of the formula above. */
struct FPhysicalCocModel
{
	float FocusDistance = 0.0f; // cm
	/** Pixels: of a point at infinity. Negative where the lens focuses nearer than its focal length: no blur. */
	float InfinityRadius = 0.0f;
	float MaxForegroundRadius = 0.0f; // pixels, above 0
	float MaxBackgroundRadius = 0.0f;
	float DepthBlurRadius = 0.0f;    // pixels, at infinity
	float DepthBlurHalfDepth = 1.0f; // cm at which it has half of that; above 0

	/** ViewWidth: pixels. CotHalfFov: cotangent of half the horizontal field of view, as in the projection's [0][0]. */
	DRYDOCK_API static FPhysicalCocModel Compile(
		const FFinalPostProcessSettings& Settings, int32 ViewWidth, float CotHalfFov);

	/** Signed radius, pixels; Depth in cm. */
	DRYDOCK_API float DepthToCocRadius(float Depth) const;
};

/** Whether the settings focus at all. */
DRYDOCK_API bool IsEnabled(const FFinalPostProcessSettings& Settings);

/** SceneColor itself where there is nothing to do. */
DRYDOCK_API FScreenPassTexture AddPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures, const FScreenPassTexture& SceneColor,
	const FPhysicalCocModel& Model);

} // namespace DiaphragmDOF
