// Lays the separate translucency of a frame over the picture, which by then has its depth of field. Source: engine
// ComposeSeparateTranslucency.usf (the formula).
//
//   result = color * translucency.a + translucency.rgb
//
// Contract. Translucency is premultiplied radiance, pre-exposed as the picture is; its alpha is the transmittance of
// what lies behind, 1 where there is nothing. The picture's alpha, extent, rect and format are kept. Rects of unequal
// size are stretched over each other bilinearly. A pixel with transmittance 1 and no radiance keeps its value. NaN and
// infinities pass on, at their own pixel; infinite light behind a transmittance of 0 is NaN. Any size from 1x1.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

DRYDOCK_API FScreenPassTexture AddSeparateTranslucencyCompositionPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, const FScreenPassTexture& SeparateTranslucency);

} // namespace Drydock
