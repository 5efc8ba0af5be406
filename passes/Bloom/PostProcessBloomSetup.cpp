// The pass that keeps what is bright enough to bloom, and its factory. Source: engine file PostProcessBloomSetup.cpp;
// toon bloom: the article's patch of it, and its correction.
#include "Bloom/PostProcessBloomSetup.h"

#include "Bloom/BloomSetupShaders.h"
#include "Exposure/ExposureFactory.h"
#include "PassFactory.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/DrawRegion.h"
#include "Screen/RasterTarget.h"

#include <cmath>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FBloomSetupPS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FBloomSetupCS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupCS", SF_Compute);

} // namespace Drydock

namespace
{

using namespace Drydock;

/** The patch is in the pixel shader alone, as printed: compute loses it. */
EToonBloom ChooseToonBloom(const FBloomSetupInputs& Inputs, bool bCompute)
{
	if (!Inputs.Toon)
	{
		return EToonBloom::None;
	}
	if (!Drydock::IsToonBloomAsPrinted())
	{
		return EToonBloom::Corrected;
	}
	return bCompute ? EToonBloom::None : EToonBloom::AsPrinted;
}

/** Colour at the resolution of the ids. */
FScreenPassTexture FindFullResolution(const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	if (Inputs.Toon->SceneColor.IsValid())
	{
		return Inputs.Toon->SceneColor;
	}
	const FRDGTextureRef SceneColor = Inputs.Toon->SceneTextures->GetContents()->SceneColorTexture;
	const FIntPoint Extent = SceneColor ? SceneColor->Desc.Extent : FIntPoint(0, 0);
	const bool bHoldsView = Extent.X >= View.ViewRect.Max.X && Extent.Y >= View.ViewRect.Max.Y;
	const bool bIsInput = Inputs.SceneColor.ViewRect.Size() == View.ViewRect.Size();
	return bHoldsView && !bIsInput ? FScreenPassTexture(SceneColor, View.ViewRect) : Inputs.SceneColor;
}

/** The setup's input, over which what toon pixels reach is drawn with the factor in it. */
FScreenPassTexture AddToonColorWithin(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs,
	const Drydock::FToonBloomInputs& MaskInputs)
{
	// A downsampled texel reads at most three texels around its place; one more for the rounding of the scale.
	constexpr int32 Reach = 4;
	const FIntRect& Full = MaskInputs.SceneColor.ViewRect;
	const FIntRect& Half = Inputs.SceneColor.ViewRect;
	const FIntRect Reached = Drydock::GrowRect(
		Drydock::ScaleRectOutward(Drydock::GrowRect(*MaskInputs.ToonBounds, Reach, Reach), Full.Size(), Half.Size()), 1,
		1);
	FIntRect Drawn = Drydock::PlaceRect(Reached, Half);
	const FIntRect Read =
		Drydock::GrowRect(Drydock::ScaleRectOutward(Drawn - Half.Min, Half.Size(), Full.Size()), Reach, Reach);
	const FScreenPassTexture Masked =
		Drydock::AddToonBloomMaskPass(GraphBuilder, View, MaskInputs, Drydock::PlaceRect(Read, Full));

	FScreenPassRenderTarget Output =
		Drydock::CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("ToonBloomHalfResolution"));
	AddCopyTexturePass(GraphBuilder, Inputs.SceneColor.Texture, Output.Texture, Half.Min, Half.Min, Half.Size());
	if (Full.Size() == Half.Size())
	{
		Drawn = Drydock::PlaceRect(*MaskInputs.ToonBounds, Half);
		AddCopyTexturePass(
			GraphBuilder, Masked.Texture, Output.Texture, Drawn.Min - Half.Min + Full.Min, Drawn.Min, Drawn.Size());
		return FScreenPassTexture(Output.Texture, Half);
	}
	Output.LoadAction = ERenderTargetLoadAction::ELoad;
	FDownsamplePassInputs DownsampleInputs;
	DownsampleInputs.SceneColor = Masked;
	DownsampleInputs.Quality = Inputs.DownsampleQuality;
	DownsampleInputs.UserSuppliedOutput = Output;
	DownsampleInputs.DrawRect = Drawn;
	return AddDownsamplePass(GraphBuilder, View, DownsampleInputs);
}

/** The setup's input with the factor in it: masked at full resolution, then downsampled as the input was. */
FScreenPassTexture AddToonColor(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	const Drydock::FRDGEffectScope EffectScope(GraphBuilder, "ToonBloom");
	Drydock::FToonBloomInputs MaskInputs = *Inputs.Toon;
	MaskInputs.SceneColor = FindFullResolution(View, Inputs);
	if (MaskInputs.ToonBounds && !View.bUseComputePasses)
	{
		return AddToonColorWithin(GraphBuilder, View, Inputs, MaskInputs);
	}
	const FScreenPassTexture Masked = Drydock::AddToonBloomMaskPass(GraphBuilder, View, MaskInputs);
	if (Masked.ViewRect.Size() == Inputs.SceneColor.ViewRect.Size())
	{
		return Masked;
	}
	FDownsamplePassInputs DownsampleInputs;
	DownsampleInputs.Name = TEXT("ToonBloomHalfResolution");
	DownsampleInputs.SceneColor = Masked;
	DownsampleInputs.Quality = Inputs.DownsampleQuality;
	DownsampleInputs.FormatOverride = Inputs.SceneColor.Texture->Desc.Format;
	return AddDownsamplePass(GraphBuilder, View, DownsampleInputs);
}

} // namespace

namespace Drydock
{

namespace
{

const FPassFactoryRegistration GBloomSetup({
	.Type = "BloomSetup",
	.Doc = "Keeps what is bright enough to bloom.",
	.Inputs = {{"Input", PictureResource, "Linear, pre-exposed."}},
	.Parameters = {FParameterSpec::Number("Threshold", 1.0, -1.0, 1e6, "In exposed luminance; -1: no threshold."),
		MakeExposureScaleSpec()},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FBloomSetupInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Threshold = Arguments.Values.GetFloat("Threshold");
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, Arguments.Values);
		return AddBloomSetupPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock

FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);
	check(!Inputs.Toon || Inputs.Toon->ToonIntensity > -1.0f);

	const bool bCompute = View.bUseComputePasses;
	const EToonBloom ToonBloom = ChooseToonBloom(Inputs, bCompute);

	const FScreenPassRenderTarget Output = Drydock::CreateScreenTarget(
		GraphBuilder, Inputs.SceneColor.Texture->Desc, Inputs.SceneColor.ViewRect, TEXT("BloomSetup"), bCompute);

	const FScreenPassTextureViewport Viewport(Inputs.SceneColor);

	FBloomSetupParameters BloomSetup;
	BloomSetup.View = View.ViewUniformBuffer;
	BloomSetup.Input = GetScreenPassTextureViewportParameters(Viewport);
	BloomSetup.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	BloomSetup.InputTexture = Inputs.SceneColor.Texture;
	BloomSetup.InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	BloomSetup.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	BloomSetup.BloomThreshold = Inputs.Threshold;
	BloomSetup.LocalExposure = Drydock::GetLocalExposureShaderParameters(Inputs.LocalExposure);

	BloomSetup.ToonIntensity = 1.0f;
	if (Inputs.Toon)
	{
		BloomSetup.SceneTextures = Inputs.Toon->SceneTextures;
		BloomSetup.ToonIntensity = Inputs.Toon->ToonIntensity;
	}
	if (ToonBloom == EToonBloom::Corrected)
	{
		const FScreenPassTexture Toon = AddToonColor(GraphBuilder, View, Inputs);
		BloomSetup.Toon = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Toon));
		BloomSetup.ToonTexture = Toon.Texture;
	}

	FBloomSetupPermutation Permutation;
	// Written so that a NaN threshold, which no comparison holds for, means none.
	Permutation.Set<FThresholdDimension>(
		Inputs.Threshold > -1.0f || (View.EngineProfile.bBloomRampWithoutThreshold && std::isfinite(Inputs.Threshold)));
	Permutation.Set<FToonBloomDimension>(ToonBloom);
	Permutation.Set<FLocalExposureDimension>(Inputs.LocalExposure.IsValid());

	const FString Name = FString::Printf(TEXT("BloomSetup %dx%d"), Output.ViewRect.Width(), Output.ViewRect.Height());
	return Drydock::AddScreenShaderPass<FBloomSetupPS, FBloomSetupCS>(GraphBuilder, View, {Name, Output, bCompute},
		BloomSetup, Permutation, &FBloomSetupCS::FParameters::BloomOutput);
}
