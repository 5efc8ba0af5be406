// Source: engine file PostProcessBloomSetup.cpp (AddGaussianBloomPasses).
#include "PostProcessGaussianBloom.h"

#include "HAL/IConsoleManager.h"
#include "PostProcessWeightedSampleSum.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"

namespace
{

TAutoConsoleVariable<int32> CVarBloomQuality(TEXT("r.BloomQuality"), 5,
	TEXT("0 off; 1, 2: three stages; 3: four; 4: five; 5: six (default). Coarse stages come first."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarGaussianBloomCross(TEXT("r.GaussianBloom.Cross"), 0.0f,
	TEXT("Sharpens the centre of the bloom kernel: positive in both directions, negative in the vertical one only. "
		 "Default 0."),
	ECVF_RenderThreadSafe);

/** A stage this small would copy its level. */
constexpr float SmallestBloomSize = 1e-8f;

struct FBloomStage
{
	float Size; // percent of the view's width, before BloomSizeScale
	FLinearColor Tint;
	const TCHAR* NameX;
	const TCHAR* NameY;
};

} // namespace

EBloomQuality GetBloomQuality()
{
	return static_cast<EBloomQuality>(FMath::Clamp(CVarBloomQuality.GetValueOnRenderThread(),
		static_cast<int32>(EBloomQuality::Disabled), static_cast<int32>(EBloomQuality::MAX) - 1));
}

uint32 GetBloomStageCount(EBloomQuality Quality)
{
	constexpr uint32 StageCounts[] = {0, 3, 3, 4, 5, 6};
	static_assert(UE_ARRAY_COUNT(StageCounts) == static_cast<uint32>(EBloomQuality::MAX));
	return StageCounts[static_cast<uint32>(Quality)];
}

FScreenPassTexture AddGaussianBloomPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTextureDownsampleChain* SceneDownsampleChain)
{
	check(SceneDownsampleChain);
	constexpr uint32 LevelCount = static_cast<uint32>(EBloomQuality::MAX);
	check(SceneDownsampleChain->GetLevelCount() >= LevelCount);

	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FBloomStage Stages[] = {
		{Settings.Bloom6Size, Settings.Bloom6Tint, TEXT("Bloom6X"), TEXT("Bloom6Y")},
		{Settings.Bloom5Size, Settings.Bloom5Tint, TEXT("Bloom5X"), TEXT("Bloom5Y")},
		{Settings.Bloom4Size, Settings.Bloom4Tint, TEXT("Bloom4X"), TEXT("Bloom4Y")},
		{Settings.Bloom3Size, Settings.Bloom3Tint, TEXT("Bloom3X"), TEXT("Bloom3Y")},
		{Settings.Bloom2Size, Settings.Bloom2Tint, TEXT("Bloom2X"), TEXT("Bloom2Y")},
		{Settings.Bloom1Size, Settings.Bloom1Tint, TEXT("Bloom1X"), TEXT("Bloom1Y")},
	};
	static_assert(UE_ARRAY_COUNT(Stages) == LevelCount);

	const float TintScale = Settings.BloomIntensity / static_cast<float>(LevelCount);
	const float Cross = CVarGaussianBloomCross.GetValueOnRenderThread();

	RDG_EVENT_SCOPE(GraphBuilder, "GaussianBloom");
	FScreenPassTexture Bloom;
	for (uint32 StageIndex = 0; StageIndex < GetBloomStageCount(GetBloomQuality()); ++StageIndex)
	{
		const FBloomStage& Stage = Stages[StageIndex];
		if (!(Stage.Size > SmallestBloomSize))
		{
			continue;
		}

		FGaussianBlurInputs PassInputs;
		PassInputs.NameX = Stage.NameX;
		PassInputs.NameY = Stage.NameY;
		PassInputs.Filter = SceneDownsampleChain->GetTexture(LevelCount - 1 - StageIndex);
		PassInputs.Additive = Bloom;
		PassInputs.CrossCenterWeight = FVector2f(FMath::Max(Cross, 0.0f), FMath::Abs(Cross));
		PassInputs.KernelSizePercent = Stage.Size * Settings.BloomSizeScale;
		PassInputs.TintColor = FLinearColor(
			Stage.Tint.R * TintScale, Stage.Tint.G * TintScale, Stage.Tint.B * TintScale, Stage.Tint.A * TintScale);
		Bloom = AddGaussianBlurPass(GraphBuilder, View, PassInputs);
	}
	return Bloom;
}
