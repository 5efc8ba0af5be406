// Adds bloom's passes: setup where something calls for it, then the sum of Gaussians or the convolution. Source:
// engine PostProcess/PostProcessing.cpp.
#include "Chain/BloomChain.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessGaussianBloom.h"
#include "Effects/Effect.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/PostProcessDownsample.h"

#include <limits>

namespace
{

constexpr float NoThreshold = -1.0f;
constexpr float NoRamp = -std::numeric_limits<float>::infinity(); // in no version of the engine

FScreenPassTexture AddHalf(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Picture,
	const TCHAR* Name, EDownsampleQuality Quality, EPixelFormat Format)
{
	FDownsamplePassInputs Inputs;
	Inputs.Name = Name;
	Inputs.SceneColor = Picture;
	Inputs.Quality = Quality;
	Inputs.FormatOverride = Format;
	return AddDownsamplePass(GraphBuilder, View, Inputs);
}

FBloomSetupInputs MakeSetup(const FBloomChainInputs& Inputs, const FScreenPassTexture& Picture, float Threshold)
{
	FBloomSetupInputs Setup;
	Setup.SceneColor = Picture;
	Setup.EyeAdaptationBuffer = Inputs.EyeAdaptationBuffer;
	Setup.Threshold = Threshold;
	if (Inputs.Toon != nullptr)
	{
		Setup.Toon = *Inputs.Toon;
		Setup.DownsampleQuality = GetDownsampleQuality();
	}
	return Setup;
}

/** The threshold is not read, as in the engine. The smaller pictures are there for r.Bloom.ScreenPercentage and are
 * culled where it asks for none. */
FBloomChainOutputs AddFFTBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs)
{
	FFFTBloomInputs FFTInputs{Inputs.SceneColor, Inputs.HalfResolution, Inputs.SceneDownsampleChain->GetTexture(1)};
	if (Inputs.Toon != nullptr)
	{
		FFTInputs.SceneColor = AddBloomSetupPass(GraphBuilder, View, MakeSetup(Inputs, Inputs.SceneColor, NoRamp));
		// As the scene's own, so that a factor of 1 changes no bit.
		const EPixelFormat Format = Inputs.HalfResolution.Texture->Desc.Format;
		FFTInputs.HalfResolution = AddHalf(
			GraphBuilder, View, FFTInputs.SceneColor, TEXT("Bloom.HalfResolution"), GetDownsampleQuality(), Format);
		FFTInputs.QuarterResolution = AddHalf(GraphBuilder, View, FFTInputs.HalfResolution,
			TEXT("Bloom.QuarterResolution"), GetDownsampleChainQuality(), Format);
	}
	const FFFTBloomOutput Output = AddFFTBloomPass(GraphBuilder, View, FFTInputs);
	return {Output.BloomTexture, Output.SceneColorApplyParameters};
}

} // namespace

FBloomChainOutputs AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs)
{
	RDG_EVENT_SCOPE(GraphBuilder, "Bloom");
	if (IsFFTBloomEnabled(View))
	{
		const Drydock::FRDGEffectScope Scope(GraphBuilder, *Drydock::GFFTBloomEffect.Name);
		return AddFFTBloomPasses(GraphBuilder, View, Inputs);
	}
	const float Threshold = View.FinalPostProcessSettings.BloomThreshold;
	if (!(Threshold > NoThreshold) && Inputs.Toon == nullptr && !Inputs.LocalExposure.IsValid())
	{
		return {AddGaussianBloomPasses(GraphBuilder, View, Inputs.SceneDownsampleChain)};
	}
	FBloomSetupInputs Setup = MakeSetup(Inputs, Inputs.HalfResolution, Threshold);
	Setup.LocalExposure = Inputs.LocalExposure;
	FTextureDownsampleChain BloomChain;
	BloomChain.Init(GraphBuilder, View, AddBloomSetupPass(GraphBuilder, View, Setup), GetDownsampleChainQuality(),
		TEXT("BloomDownsample"));
	return {AddGaussianBloomPasses(GraphBuilder, View, &BloomChain)};
}
