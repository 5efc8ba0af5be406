// A sum of Gaussians over the levels of a downsample chain, for any texture.
#pragma once

#include "PostProcess/PostProcessDownsample.h"
#include "ScreenPass.h"

/** One stage: diameter in percent of the picture's width, and its weight. */
struct FGaussianBlurStage
{
	float Size = 0.0f;
	FLinearColor Tint = FLinearColor::White;
};

/** Stages from the finest level on; their weights are scaled so that they sum to 1. */
FScreenPassTexture AddBlurPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FSceneDownsampleChain* DownsampleChain, const TArray<FGaussianBlurStage>& Stages);

/** Makes the chain of a texture, and blurs it. */
FScreenPassTexture AddTextureBlurPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture Input,
	const TArray<FGaussianBlurStage>& Stages);
