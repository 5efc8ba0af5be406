// Tint: multiplies a part of the picture by a colour. The smallest extension there is, to see where a hook is and who
// comes after whom:
//
//     "extensions": [{"type": "Tint", "pass": "Tonemap", "Color": [1, 0.5, 0.5], "Right": 0.5}]
//
// Contract. Same extent, rect and format as the input; colour of the pixels whose centre is inside the area times
// Color, everything else as it is. NaN and infinities pass on (times 0: NaN).
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FTintInputs
{
	/** [Required] */
	FScreenPassTexture SceneColor;
	/** [Optional] Written in place of a new texture. */
	FScreenPassRenderTarget OverrideOutput;
	/** Alpha is not used. */
	FLinearColor Color = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	/** Left, top, right, bottom, as fractions of the picture. */
	FVector4f Area = FVector4f(0.0f, 0.0f, 1.0f, 1.0f);
};

DRYDOCK_API FScreenPassTexture AddTintPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTintInputs& Inputs);

} // namespace Drydock
