// Depth of field: a simplification of the engine's diaphragm depth of field. Source: engine file
// PostProcess/DiaphragmDOF.h (lens, limits, order of passes); the gather is drydock's own.
//
// Radius of the circle of confusion of a depth d, thin lens, in pixels of the view's width W:
//   f = SensorWidth / 2 * cot(half field of view),  A = f / Fstop
//   r(d) = A * f / (FocalDistance - f) * (d - FocalDistance) / d / SensorWidth * W / 2
// positive behind the focus, negative before it; at most r.DOF.Kernel.MaxBackgroundRadius and MaxForegroundRadius. The
// blur of the air (DepthOfFieldDepthBlur*): behind the focus at least Radius * W / 1920 * (1 - 2^(-d / Amount)). None
// is larger than W.
//
// The bokeh, the picture of a point out of focus, has the form of the lens's opening, as the settings' tooltips
// say (memory): a disc at DepthOfFieldMinFstop; at larger stops as many arcs as there are blades, bent as the edge of
// the disc is; straight sides where DepthOfFieldMinFstop is 0. Its area is that of the disc of radius r, so that a stop
// lets through the light of its number; a corner points up behind the focus and down before it (both drydock's choice).
// r.DOF.Gather.EnableBokehSettings 0: a disc.
//
// DOF Setup: half size, colour and radius. DOF TileMax, NeighborMax: the largest radius that can reach a tile of 16 x
// 16. DOF Gather: the bokehs of all samples, each of the light and the opacity of what it stands for. Behind the focus
// a pixel is the mean of what reaches it, where nothing reaches over what is nearer than itself; before the focus what
// reaches it covers it. If bokehs would cover a pixel more than once, those of nearer things come first. The colour
// behind something before the focus is unknown: it is filled in from around. DOF Recombine: full size, mixed by the
// radius; a pixel before the focus gives its own place away to the extent that it spreads over others. These features
// of the engine are missing: scattered highlights, the slight out-of-focus pass, squeeze, Petzval, barrel, temporal
// accumulation. Samples lie on a grid of at most 17 x 17: above 16 pixels of radius they are farther apart than pixels,
// and a single bright pixel shows the grid.
//
// Contract. The picture is unchanged bit for bit where no radius of half a pixel reaches. A constant stays constant.
// Every result is a mix of input colours. A spot keeps its light, unless something nearer, or the picture's edge, hides
// a part of it. A depth that is not finite or not above 0 counts as in focus. FocalDistance or Fstop 0 and below: no
// pass. NaN, infinities and negatives go where the pixels that hold them go, and nowhere else: what is in focus keeps
// its bits. Nothing outside the rect is read. Any size from 1x1.
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

enum class EBokehShape : uint8
{
	Circle,
	StraightBlades,
	RoundedBlades,
};

/** The form of the opening, for a radius of 1 of the disc of its area. */
struct FBokehModel
{
	EBokehShape BokehShape = EBokehShape::Circle;
	int32 DiaphragmBladeCount = 0;               // of a circle 0; else 4 to 16
	double CocRadiusToCircumscribedRadius = 1.0; // centre to a corner
	double CocRadiusToIncircleRadius = 1.0;      // centre to the middle of a side
	double DiaphragmBladeRadius = 1.0;           // of RoundedBlades: of the arcs

	DRYDOCK_API static FBokehModel Compile(const FFinalPostProcessSettings& Settings);

	/** Radius of the bokeh whose edge passes through this offset: 1 on the edge of the bokeh of radius 1. The offset's
	 * y points down, to a corner. */
	DRYDOCK_API double MeasureDistance(double X, double Y) const;
};

/** Whether the settings focus at all. */
DRYDOCK_API bool IsEnabled(const FFinalPostProcessSettings& Settings);

/** SceneColor itself where there is nothing to do. */
DRYDOCK_API FScreenPassTexture AddPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures, const FScreenPassTexture& SceneColor,
	const FPhysicalCocModel& Model, const FBokehModel& Bokeh);

} // namespace DiaphragmDOF
