// Source: engine PostProcess/PostProcessing.cpp (order of the chain, what each part needs).
#include "PostProcess/PostProcessingChain.h"

#include "PostProcessBloomSetup.h"
#include "PostProcessDownsample.h"
#include "PostProcessEyeAdaptation.h"
#include "PostProcessGaussianBloom.h"
#include "PostProcessTonemap.h"
#include "RenderGraphBuilder.h"

#include <algorithm>

namespace
{

bool IsActive(const std::vector<Drydock::FEffectDecision>& Effects, const char* Name)
{
	return std::any_of(Effects.begin(), Effects.end(),
		[&](const Drydock::FEffectDecision& Effect) { return Effect.bActive && Effect.Name == Name; });
}

/** Half resolution, in the format of all that follows from it. */
FScreenPassTexture AddHalfResolutionPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor)
{
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("HalfResolutionSceneColor");
	Inputs.SceneColor = SceneColor;
	Inputs.Quality = GetDownsampleQuality();
	Inputs.FormatOverride = PF_FloatRGB;
	return AddDownsamplePass(GraphBuilder, View, Inputs);
}

FScreenPassTexture AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, FRDGBufferRef EyeAdaptationBuffer)
{
	RDG_EVENT_SCOPE(GraphBuilder, "Bloom");
	const FScreenPassTexture HalfResolution = AddHalfResolutionPass(GraphBuilder, View, SceneColor);

	// As in the engine the scene's own chain is always declared; with a threshold nobody reads it, and the graph culls
	// it.
	FTextureDownsampleChain SceneChain;
	SceneChain.Init(GraphBuilder, View, HalfResolution, GetDownsampleChainQuality(), TEXT("SceneDownsample"));
	const float Threshold = View.FinalPostProcessSettings.BloomThreshold;
	if (!(Threshold > -1.0f))
	{
		return AddGaussianBloomPasses(GraphBuilder, View, &SceneChain);
	}

	FBloomSetupInputs SetupInputs;
	SetupInputs.SceneColor = HalfResolution;
	SetupInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
	SetupInputs.Threshold = Threshold;
	FTextureDownsampleChain BloomChain;
	BloomChain.Init(GraphBuilder, View, AddBloomSetupPass(GraphBuilder, View, SetupInputs), GetDownsampleChainQuality(),
		TEXT("BloomDownsample"));
	return AddGaussianBloomPasses(GraphBuilder, View, &BloomChain);
}

} // namespace

FPostProcessingChainOutputs AddPostProcessingPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FPostProcessingChainInputs& Inputs, const std::vector<Drydock::FEffectDecision>& Effects)
{
	RDG_EVENT_SCOPE(GraphBuilder, "PostProcessing");
	check(Inputs.SceneColor.IsValid());

	const FRDGBufferRef EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, Inputs.ExposureScale);
	FTonemapInputs TonemapInputs;
	TonemapInputs.SceneColor = Inputs.SceneColor;
	TonemapInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
	if (IsActive(Effects, "Bloom"))
	{
		TonemapInputs.Bloom = AddBloomPasses(GraphBuilder, View, Inputs.SceneColor, EyeAdaptationBuffer);
	}

	FPostProcessingChainOutputs Outputs;
	Outputs.SceneLinear = Inputs.SceneColor;
	Outputs.Final = AddTonemapPass(GraphBuilder, View, TonemapInputs);
	return Outputs;
}
