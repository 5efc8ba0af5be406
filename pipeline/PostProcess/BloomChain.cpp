// Source: engine PostProcess/PostProcessing.cpp.
#include "PostProcess/BloomChain.h"

#include "PostProcessBloomSetup.h"
#include "PostProcessDownsample.h"
#include "PostProcessGaussianBloom.h"
#include "SceneRendering.h"

FScreenPassTexture AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs)
{
	RDG_EVENT_SCOPE(GraphBuilder, "Bloom");
	const float Threshold = View.FinalPostProcessSettings.BloomThreshold;
	if (!(Threshold > -1.0f) && Inputs.Toon == nullptr)
	{
		return AddGaussianBloomPasses(GraphBuilder, View, Inputs.SceneDownsampleChain);
	}

	FBloomSetupInputs SetupInputs;
	SetupInputs.SceneColor = Inputs.HalfResolution;
	SetupInputs.EyeAdaptationBuffer = Inputs.EyeAdaptationBuffer;
	SetupInputs.Threshold = Threshold;
	if (Inputs.Toon != nullptr)
	{
		SetupInputs.SceneTextures = Inputs.Toon->SceneTextures;
		SetupInputs.ToonIntensity = Inputs.Toon->ToonIntensity;
		SetupInputs.FullResolutionSceneColor = Inputs.SceneColor;
		SetupInputs.DownsampleQuality = GetDownsampleQuality();
	}
	FTextureDownsampleChain BloomChain;
	BloomChain.Init(GraphBuilder, View, AddBloomSetupPass(GraphBuilder, View, SetupInputs), GetDownsampleChainQuality(),
		TEXT("BloomDownsample"));
	return AddGaussianBloomPasses(GraphBuilder, View, &BloomChain);
}
