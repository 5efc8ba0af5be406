// Adds bloom's passes: setup where something calls for it, then the sum of Gaussians or the convolution. Source:
// engine PostProcess/PostProcessing.cpp.
#include "Chain/BloomChain.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessGaussianBloom.h"
#include "Bloom/ToonBloomSetup.h"
#include "CodeScope.h"
#include "Effects/Effect.h"
#include "Overlay/ChainPlaces.h"
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

/** The setup pass, with toon bloom where that is active. */
FScreenPassTexture AddSetup(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs,
	const FScreenPassTexture& Picture, float Threshold, const Drydock::FLocalExposureTextures& LocalExposure)
{
	FBloomSetupInputs Setup;
	Setup.SceneColor = Picture;
	Setup.EyeAdaptationBuffer = Inputs.EyeAdaptationBuffer;
	Setup.Threshold = Threshold;
	Setup.EyeAdaptationParameters = &Inputs.EyeAdaptationParameters;
	Setup.LocalExposureParameters = &Inputs.LocalExposureParameters;
	if (LocalExposure.IsValid())
	{
		LocalExposure.GiveTo(Setup);
	}
	return Inputs.Toon != nullptr
			   ? Drydock::AddToonBloomSetupPass(GraphBuilder, View, Setup, *Inputs.Toon, GetDownsampleQuality())
			   : AddBloomSetupPass(GraphBuilder, View, Setup);
}

/** The picture after the block of an overlay, whether that adds the setup or not. */
FScreenPassTexture RunSetupPlace(const Drydock::FActiveReplacement& Place, FRDGBuilder& GraphBuilder,
	const FViewInfo& View, const FBloomChainInputs& Inputs, bool bRequired)
{
	FScreenPassTexture DownsampleInput = Inputs.HalfResolution;
	Drydock::FBloomSetupPlace Locals = {GraphBuilder, View, *Inputs.PostProcessing,
		View.FinalPostProcessSettings.BloomThreshold, bRequired, DownsampleInput, Inputs.EyeAdaptationBuffer,
		Inputs.EyeAdaptationParameters, Inputs.LocalExposureParameters, Inputs.LocalExposure.BilateralGrid,
		Inputs.LocalExposure.BlurredLogLuminance, {Drydock::IsLocalExposureAppliedToBloom()}};
	Drydock::CallCode(
		Place.Owner, [&] { reinterpret_cast<void (*)(Drydock::FBloomSetupPlace&)>(Place.Address)(Locals); });
	if (!(DownsampleInput == Inputs.HalfResolution))
	{
		Drydock::TakePassReplacement("AddBloomSetupPass"); // which the block calls in its own library
	}
	return DownsampleInput;
}

/** The threshold is not read, as in the engine. The smaller pictures are there for r.Bloom.ScreenPercentage and are
 * culled where it asks for none. */
FBloomChainOutputs AddFFTBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomChainInputs& Inputs)
{
	FFFTBloomInputs FFTInputs{Inputs.SceneColor, Inputs.HalfResolution, Inputs.SceneDownsampleChain->GetTexture(1)};
	if (Inputs.Toon != nullptr)
	{
		FFTInputs.SceneColor = AddSetup(GraphBuilder, View, Inputs, Inputs.SceneColor, NoRamp, {});
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
	const bool bRequired = Threshold > NoThreshold || Inputs.LocalExposure.IsValid();
	FScreenPassTexture BloomInput = Inputs.HalfResolution;
	if (const Drydock::FActiveReplacement* const Place = Drydock::TakePassReplacement(Drydock::BloomSetupPlaceName))
	{
		BloomInput = RunSetupPlace(*Place, GraphBuilder, View, Inputs, bRequired);
	}
	else if (bRequired || Inputs.Toon != nullptr)
	{
		BloomInput = AddSetup(GraphBuilder, View, Inputs, Inputs.HalfResolution, Threshold, Inputs.LocalExposure);
	}
	if (BloomInput == Inputs.HalfResolution)
	{
		return {AddGaussianBloomPasses(GraphBuilder, View, Inputs.SceneDownsampleChain)};
	}
	FTextureDownsampleChain BloomChain;
	BloomChain.Init(GraphBuilder, View, BloomInput, GetDownsampleChainQuality(), TEXT("BloomDownsample"));
	return {AddGaussianBloomPasses(GraphBuilder, View, &BloomChain)};
}
