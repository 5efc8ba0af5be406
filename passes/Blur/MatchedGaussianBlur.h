// The Gaussian of a given standard deviation, tap by tap, to compare other blurs with (the dual Kawase blur's
// UseGaussian, studies). Config type: MatchedGaussian.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FMatchedGaussianBlurInputs
{
	/** [Required] What is blurred. */
	FScreenPassTexture SceneColor;

	/** [Optional] Written in place of a new texture; its rect has the size of the input's. */
	FScreenPassRenderTarget OverrideOutput;

	/** Pixels, at least 0.5. */
	double StandardDeviation = 1.0;

	/** The distance where the taps end, in standard deviations, above 0. */
	double ReachInDeviations = 3.0;

	/** Rows, then columns, in two passes. Else in one, as the article does it: (2 R + 1)^2 taps, R standard deviations
	 * of the reach. */
	bool bSeparable = false;
};

/** The Gaussian to compare with: its taps at texel centres, reach 3 standard deviations by default, corrected for the
 * variance of the cut tails; clamp addressing. Extent, rect, format and the rules for constants, NaN and infinities are
 * those of the corrected blur. */
DRYDOCK_API FScreenPassTexture AddMatchedGaussianBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FMatchedGaussianBlurInputs& Inputs);

} // namespace Drydock
