// Generalizes the bloom's sum of Gaussians: the caller gives stages, sizes, tints and scale. Source: article
// "Toon-shadow blur" (AddGaussianSumPasses, AddTextureGaussianSumPasses), after engine file PostProcessBloomSetup.cpp.
//
// From the coarsest level of a downsample chain to the finest: blur the level, times tint * TintScale, plus what came
// before. Hazards are those of the blur (PostProcessWeightedSampleSum.h), stage by stage; levels of high quality
// make NaN and negatives 0, the finest keeps them. Any size from 1x1: levels stop there.
#pragma once

#include "Blur/PostProcessWeightedSampleSum.h"
#include "CoreMinimal.h"
#include "Screen/PostProcessDownsample.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** One Gaussian of the sum. */
struct FGaussianSumStage
{
	/** Names of its two passes and their outputs; kept as pointers. */
	const TCHAR* NameX = nullptr;
	const TCHAR* NameY = nullptr;
	/** Diameter in percent of the view's width, before SizeScale. 0 and below: the stage is left out. */
	float Size = 0.0f;
	FLinearColor Tint = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
};

struct FGaussianSumInputs
{
	/** Coarsest first: stage i blurs level Num - 1 - i of the chain. */
	TArray<FGaussianSumStage> Stages;
	/** Stages that run, from the coarsest on. */
	uint32 StageCount = 0;
	float SizeScale = 1.0f;
	/** Multiplies every tint. */
	FLinearColor TintScale = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	/** Sharpness of the centre: positive in both directions, negative in the vertical one only. */
	float Cross = 0.0f;
	/** The texels outside: the edge texel (true), or black (the engine's bloom). */
	bool bClampAddressing = false;
};

/** One over the sum of the tints of the stages that run, channel by channel, so that a constant stays that constant; 0
 *  where a channel's sum is 0. */
DRYDOCK_API FLinearColor GetNormalizingTintScale(const FGaussianSumInputs& Inputs);

/** Chain: at least as many levels as there are stages. Gives the finest stage that ran, or an invalid texture when none
 *  did. */
DRYDOCK_API FScreenPassTexture AddGaussianSumPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FTextureDownsampleChain& Chain, const FGaussianSumInputs& Inputs);

/** Blurs any texture: half resolution, downsample chain, Gaussian sum. Format: of all that is made; Name: of the event
 *  scope and the levels. The result has half of Source's resolution; invalid when no stage runs. */
DRYDOCK_API FScreenPassTexture AddTextureGaussianSumPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& Source, EPixelFormat Format, const TCHAR* Name, const FGaussianSumInputs& Inputs);

} // namespace Drydock
