// The stages of a sum of Gaussians. Source: article "Toon-shadow blur"; engine file PostProcessBloomSetup.cpp.
#include "Blur/GaussianSum.h"

#include "RenderGraphBuilder.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

/** A stage this small would copy its level. */
constexpr float SmallestStageSize = 1e-8f;

bool DoesStageRun(const FGaussianSumInputs& Inputs, int32 StageIndex)
{
	return static_cast<uint32>(StageIndex) < Inputs.StageCount && Inputs.Stages[StageIndex].Size > SmallestStageSize;
}

} // namespace

FLinearColor GetNormalizingTintScale(const FGaussianSumInputs& Inputs)
{
	FLinearColor Sum(0.0f, 0.0f, 0.0f, 0.0f);
	for (int32 StageIndex = 0; StageIndex < Inputs.Stages.Num(); ++StageIndex)
	{
		if (DoesStageRun(Inputs, StageIndex))
		{
			Sum += Inputs.Stages[StageIndex].Tint;
		}
	}
	const auto Invert = [](float Value)
	{
		return Value != 0.0f ? 1.0f / Value : 0.0f;
	};
	return FLinearColor(Invert(Sum.R), Invert(Sum.G), Invert(Sum.B), Invert(Sum.A));
}

FScreenPassTexture AddGaussianSumPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FTextureDownsampleChain& Chain, const FGaussianSumInputs& Inputs)
{
	const int32 NumStages = Inputs.Stages.Num();
	check(static_cast<int32>(Chain.GetLevelCount()) >= NumStages);

	FScreenPassTexture Result;
	for (int32 StageIndex = 0; StageIndex < NumStages; ++StageIndex)
	{
		if (!DoesStageRun(Inputs, StageIndex))
		{
			continue;
		}
		const FGaussianSumStage& Stage = Inputs.Stages[StageIndex];
		FGaussianBlurInputs PassInputs;
		PassInputs.NameX = Stage.NameX;
		PassInputs.NameY = Stage.NameY;
		PassInputs.Filter = Chain.GetTexture(static_cast<uint32>(NumStages - 1 - StageIndex));
		PassInputs.Additive = Result;
		PassInputs.CrossCenterWeight = FVector2f(FMath::Max(Inputs.Cross, 0.0f), FMath::Abs(Inputs.Cross));
		PassInputs.KernelSizePercent = Stage.Size * Inputs.SizeScale;
		PassInputs.TintColor = Stage.Tint * Inputs.TintScale;
		PassInputs.UseClampAddressMode = Inputs.bClampAddressing;
		Result = AddGaussianBlurPass(GraphBuilder, View, PassInputs);
	}
	return Result;
}

FScreenPassTexture AddTextureGaussianSumPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& Source, EPixelFormat Format, const TCHAR* Name, const FGaussianSumInputs& Inputs)
{
	check(Source.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "%s", Name);

	FDownsamplePassInputs HalfInputs;
	HalfInputs.Name = Name;
	HalfInputs.SceneColor = Source;
	HalfInputs.Quality = GetDownsampleQuality();
	HalfInputs.FormatOverride = Format;
	FTextureDownsampleChain Chain;
	Chain.Init(GraphBuilder, View, AddDownsamplePass(GraphBuilder, View, HalfInputs), GetDownsampleChainQuality(), Name,
		static_cast<uint32>(FMath::Max(1, Inputs.Stages.Num())));
	return AddGaussianSumPasses(GraphBuilder, View, Chain, Inputs);
}

} // namespace Drydock
