// Adds the blurs from the coarsest level to the finest, each on top of the one before.
#include "GaussianBlurPassRendering.h"

#include "PostProcess/PostProcessWeightedSampleSum.h"

FScreenPassTexture AddBlurPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FSceneDownsampleChain* DownsampleChain, const TArray<FGaussianBlurStage>& Stages)
{
	float TotalTint = 0.0f;
	for (const FGaussianBlurStage& Stage : Stages)
	{
		TotalTint += Stage.Tint.R;
	}
	FScreenPassTexture Result;
	for (int32 Index = Stages.Num() - 1; Index >= 0; --Index)
	{
		FGaussianBlurInputs PassInputs;
		PassInputs.NameX = TEXT("ToonShadowBlurX");
		PassInputs.NameY = TEXT("ToonShadowBlurY");
		PassInputs.Filter = DownsampleChain->GetTexture(Index);
		PassInputs.Additive = Result;
		PassInputs.KernelSizePercent = Stages[Index].Size;
		PassInputs.TintColor = Stages[Index].Tint * (1.0f / TotalTint);
		PassInputs.UseMirrorAddressMode = true;
		Result = AddGaussianBlurPass(GraphBuilder, View, PassInputs);
	}
	return Result;
}

FScreenPassTexture AddTextureBlurPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture Input,
	const TArray<FGaussianBlurStage>& Stages)
{
	FSceneDownsampleChain DownsampleChain;
	DownsampleChain.Init(GraphBuilder, View, Input, EDownsampleQuality::Low, TEXT("ToonShadowDownsample"));
	return AddBlurPasses(GraphBuilder, View, &DownsampleChain, Stages);
}
