// The stages of the bloom as the settings give them. Source: engine file PostProcessBloomSetup.cpp
// (AddGaussianBloomPasses).
#include "Bloom/PostProcessGaussianBloom.h"

#include "Blur/GaussianSum.h"
#include "HAL/IConsoleManager.h"
#include "PassFunctions.h"
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

} // namespace

EBloomQuality GetBloomQuality()
{
	return static_cast<EBloomQuality>(FMath::Clamp(CVarBloomQuality.GetValueOnRenderThread(),
		static_cast<int32>(EBloomQuality::Disabled), static_cast<int32>(EBloomQuality::MAX) - 1));
}

namespace Drydock
{

uint32 GetBloomStageCount(EBloomQuality Quality)
{
	constexpr uint32 StageCounts[] = {0, 3, 3, 4, 5, 6};
	static_assert(UE_ARRAY_COUNT(StageCounts) == static_cast<uint32>(EBloomQuality::MAX));
	return StageCounts[static_cast<uint32>(Quality)];
}

} // namespace Drydock

FScreenPassTexture Drydock::BuiltInAddGaussianBloomPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTextureDownsampleChain* SceneDownsampleChain)
{
	check(SceneDownsampleChain);
	constexpr uint32 LevelCount = static_cast<uint32>(EBloomQuality::MAX);
	check(SceneDownsampleChain->GetLevelCount() >= LevelCount);

	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	Drydock::FGaussianSumInputs Inputs;
	Inputs.Stages = {
		{TEXT("Bloom6X"), TEXT("Bloom6Y"), Settings.Bloom6Size, Settings.Bloom6Tint},
		{TEXT("Bloom5X"), TEXT("Bloom5Y"), Settings.Bloom5Size, Settings.Bloom5Tint},
		{TEXT("Bloom4X"), TEXT("Bloom4Y"), Settings.Bloom4Size, Settings.Bloom4Tint},
		{TEXT("Bloom3X"), TEXT("Bloom3Y"), Settings.Bloom3Size, Settings.Bloom3Tint},
		{TEXT("Bloom2X"), TEXT("Bloom2Y"), Settings.Bloom2Size, Settings.Bloom2Tint},
		{TEXT("Bloom1X"), TEXT("Bloom1Y"), Settings.Bloom1Size, Settings.Bloom1Tint},
	};
	const float TintScale = Settings.BloomIntensity / static_cast<float>(LevelCount);
	Inputs.TintScale = FLinearColor(TintScale, TintScale, TintScale, TintScale);
	Inputs.StageCount = Drydock::GetBloomStageCount(GetBloomQuality());
	Inputs.SizeScale = Settings.BloomSizeScale;
	Inputs.Cross = CVarGaussianBloomCross.GetValueOnRenderThread();

	RDG_EVENT_SCOPE(GraphBuilder, "GaussianBloom");
	return Drydock::AddGaussianSumPasses(GraphBuilder, View, *SceneDownsampleChain, Inputs);
}
