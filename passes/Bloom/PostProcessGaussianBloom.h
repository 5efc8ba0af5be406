// Bloom as a sum of Gaussians, one to a level of the downsample chain. Source: engine file PostProcessBloomSetup.h
// (AddGaussianBloomPasses).
//
// From the coarsest level to the finest: blur the level, times Tint_N * BloomIntensity / 6, plus what came before.
// Quality 1..5 (r.BloomQuality) runs 3, 3, 4, 5, 6 stages, coarse ones first, with the same scale. A stage whose size
// is 0 is left out. The intensity is inside the tints: the tonemapper adds the result as it is. Contract. A flat field
// in the interior gives value * sum(tints run) * BloomIntensity / 6; towards the edges less (border addressing of the
// blur). Hazards: those of the blur, stage by stage; levels of high quality make NaN and negatives 0, the finest keeps
// them. Any size from 1x1: levels stop there.
#pragma once

#include "CoreMinimal.h"
#include "Screen/PostProcessDownsample.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

enum class EBloomQuality : uint32
{
	Disabled,
	Q1,
	Q2,
	Q3,
	Q4,
	Q5,
	MAX
};

/** r.BloomQuality, clamped. */
DRYDOCK_API EBloomQuality GetBloomQuality();

namespace Drydock
{

/** Stages that a quality runs: 0, 3, 3, 4, 5, 6. */
DRYDOCK_API uint32 GetBloomStageCount(EBloomQuality Quality);

} // namespace Drydock

/** Settings come from View.FinalPostProcessSettings. Chain: EBloomQuality::MAX levels, level 0 half resolution. Gives
 * the finest stage that ran, or an invalid texture when none did. */
DRYDOCK_API FScreenPassTexture AddGaussianBloomPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTextureDownsampleChain* SceneDownsampleChain);
