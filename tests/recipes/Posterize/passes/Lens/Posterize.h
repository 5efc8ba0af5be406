// Posterize: rounds the picture down to a number of levels, as the recipe of docs/architecture.md makes an effect.
//
// Contract. Same extent, rect and format as the input; each of R, G and B is floor(value * Levels) / Levels, alpha as
// it is. Infinities stay, NaN stays NaN.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** Levels: from 0 to 1, above 0. */
DRYDOCK_API FScreenPassTexture AddPosterizePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor, float Levels);

} // namespace Drydock
