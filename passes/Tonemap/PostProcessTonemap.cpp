// The pass that tonemaps, and its factory. Source: engine file PostProcessTonemap.cpp.
#include "Tonemap/PostProcessTonemap.h"

#include "Exposure/ExposureFactory.h"
#include "PassFactory.h"
#include "PassFunctions.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/TextureAssets.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/TonemapLens.h"
#include "Tonemap/TonemapShaders.h"

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FTonemapPS, "/Engine/Private/PostProcessTonemap.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FTonemapCS, "/Engine/Private/PostProcessTonemap.usf", "MainCS", SF_Compute);

} // namespace Drydock

namespace
{

using namespace Drydock;

FScreenPassRenderTarget CreateOutput(FRDGBuilder& GraphBuilder, const FTonemapInputs& Inputs, bool bCompute)
{
	FRDGTextureDesc Desc = Inputs.SceneColor.Texture->Desc;
	Desc.Format = Inputs.OutputFormat;
	Desc.ClearValue = FClearValueBinding(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f));
	return Drydock::CreateScreenTarget(GraphBuilder, Desc, Inputs.SceneColor.ViewRect, TEXT("Tonemap"), bCompute);
}

/** The parts that the settings call for; of gamma only, none. */
FTonemapPermutation ChoosePermutation(
	const FViewInfo& View, const FTonemapInputs& Inputs, const FTonemapParameters& Parameters)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	FTonemapPermutation Permutation;
	Permutation.Set<FTonemapGammaOnlyDimension>(Inputs.bGammaOnly);
	if (Inputs.bGammaOnly)
	{
		return Permutation;
	}
	Permutation.Set<FTonemapBloomDimension>(Inputs.Bloom.IsValid());
	Permutation.Set<FTonemapDirtMaskDimension>(Parameters.BloomDirtMaskTexture != nullptr);
	Permutation.Set<FTonemapVignetteDimension>(Settings.VignetteIntensity > 0.0f);
	Permutation.Set<FTonemapSharpenDimension>(Parameters.SharpenAmount > 0.0f);
	Permutation.Set<FTonemapFilmGrainDimension>(Drydock::HasFilmGrain(Settings));
	Permutation.Set<FTonemapFilmGrainTextureDimension>(Parameters.FilmGrainTexture != nullptr);
	Permutation.Set<FTonemapGrainQuantizationDimension>(Parameters.GrainQuantizationStep > 0.0f);
	Permutation.Set<FTonemapColorFringeDimension>(Drydock::HasChromaticAberration(Settings));
	Permutation.Set<FTonemapLocalExposureDimension>(Inputs.LocalExposureTexture != nullptr);
	Permutation.Set<FTonemapLUTDimension>(Inputs.ColorGradingTexture != nullptr);
	Permutation.Set<FTonemapSceneColorApplyDimension>(Inputs.SceneColorApplyParamaters != nullptr);
	return Permutation;
}

void SetBloom(FRDGBuilder& GraphBuilder, const FFinalPostProcessSettings& Settings, const FScreenPassTexture& Bloom,
	FTonemapParameters& Parameters)
{
	Parameters.Bloom = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Bloom));
	Parameters.BloomTexture = Bloom.Texture;
	Parameters.BloomSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	if (Settings.BloomDirtMaskIntensity > 0.0f)
	{
		if (const FTextureRHIRef DirtMask = Drydock::FindTexturePixels(Settings.BloomDirtMask.Get()))
		{
			Parameters.BloomDirtMaskTexture =
				GraphBuilder.RegisterExternalTexture(CreateRenderTarget(DirtMask, TEXT("BloomDirtMask")));
		}
		Parameters.BloomDirtMaskSampler = Parameters.BloomSampler;
		const FLinearColor& Tint = Settings.BloomDirtMaskTint;
		Parameters.BloomDirtMaskTint = FVector3f(Tint.R, Tint.G, Tint.B) * Settings.BloomDirtMaskIntensity;
	}
}

/** Sets the parameters of lens and sensor. */
void SetLens(FRDGBuilder& GraphBuilder, const FViewInfo& View, FIntPoint Size, FTonemapParameters& Parameters)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const Drydock::FFilmGrain Grain = Drydock::MakeFilmGrain(Settings, View.UniformParameters.StateFrameIndex);
	Parameters.ChromaticAberrationParams =
		Drydock::ComputeChromaticAberration(Settings.SceneFringeIntensity, Settings.ChromaticAberrationStartOffset);
	Parameters.FilmGrainIntensities = Grain.Intensities;
	Parameters.FilmGrainRanges = Grain.Ranges;
	Parameters.FilmGrainFrame = Grain.Frame;
	const FTextureRHIRef GrainPicture =
		Drydock::HasFilmGrain(Settings) ? Drydock::FindTexturePixels(Settings.FilmGrainTexture.Get()) : nullptr;
	if (GrainPicture)
	{
		const Drydock::FFilmGrainPicture Picture = Drydock::MakeFilmGrainPicture(Grain, *GrainPicture);
		Parameters.FilmGrainTexture =
			GraphBuilder.RegisterExternalTexture(CreateRenderTarget(GrainPicture, TEXT("FilmGrainTexture")));
		Parameters.FilmGrainSampler = TStaticSamplerState<SF_Bilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI();
		Parameters.FilmGrainUVPerPixel = Picture.UVPerPixel;
		Parameters.FilmGrainUVOffset = Picture.UVOffset;
		Parameters.FilmGrainMeanInverse = Picture.MeanInverse;
	}
	Parameters.SharpenAmount = Drydock::GetSharpenAmount(Settings);
	Parameters.VignetteScale = Drydock::ComputeVignetteScale(Size);
	Parameters.VignetteIntensity = Settings.VignetteIntensity;
}

FTonemapParameters MakeParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs,
	const FScreenPassRenderTarget& Output)
{
	FTonemapParameters Parameters;
	Parameters.View = View.ViewUniformBuffer;
	Parameters.Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	Parameters.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters.ColorTexture = Inputs.SceneColor.Texture;
	Parameters.ColorSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	if (Inputs.SceneColorApplyParamaters)
	{
		Parameters.SceneColorApplyParamaters = GraphBuilder.CreateSRV(Inputs.SceneColorApplyParamaters);
	}
	Parameters.ColorScale0 = View.FinalPostProcessSettings.SceneColorTint;
	Parameters.bWriteLumaToAlpha = Inputs.bWriteAlphaChannel ? 1.0f : 0.0f;
	if (Inputs.Bloom.IsValid())
	{
		SetBloom(GraphBuilder, View.FinalPostProcessSettings, Inputs.Bloom, Parameters);
	}
	if (Inputs.LocalExposureTexture)
	{
		check(Inputs.EyeAdaptationParameters && Inputs.LocalExposureParameters && Inputs.BlurredLogLuminanceTexture);
		Parameters.EyeAdaptation = *Inputs.EyeAdaptationParameters;
		Parameters.LocalExposure = *Inputs.LocalExposureParameters;
		Parameters.LumBilateralGrid = Inputs.LocalExposureTexture;
		Parameters.LumBilateralGridSampler = Parameters.ColorSampler;
		Parameters.BlurredLogLum = Inputs.BlurredLogLuminanceTexture;
		Parameters.BlurredLogLumSampler = Parameters.ColorSampler;
	}
	Parameters.ColorGradingLUT = Inputs.ColorGradingTexture;
	Parameters.ColorGradingSampler = Parameters.ColorSampler;
	SetLens(GraphBuilder, View, Output.ViewRect.Size(), Parameters);
	Parameters.GrainQuantizationStep = Drydock::GetGrainQuantizationStep(Output.Texture->Desc.Format);
	return Parameters;
}

/** With the table, only its size and the device matter here: what made it is in it. */
void SetRemap(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs,
	FTonemapParameters& Parameters, FTonemapPermutation& Permutation)
{
	Drydock::FColorRemap Remap = Drydock::MakeColorRemap(GraphBuilder, View);
	if (Inputs.ColorGradingTexture != nullptr || Inputs.bGammaOnly)
	{
		Remap.Permutation.Set<Drydock::FColorGradingDimension>(false);
		Remap.Permutation.Set<Drydock::FLUTBlendCountDimension>(0);
	}
	if (Inputs.bGammaOnly)
	{
		Remap.Permutation.Set<Drydock::FOutputDeviceDimension>(EDisplayOutputFormat::SDR_sRGB);
	}
	if (Inputs.ColorGradingTexture != nullptr)
	{
		Remap.Parameters.LUTSize = static_cast<float>(Inputs.ColorGradingTexture->Desc.Extent.Y);
	}
	Parameters.Remap = Remap.Parameters;
	Permutation.Set<Drydock::FColorRemapPermutation>(Remap.Permutation);
}

} // namespace

namespace Drydock
{

namespace
{

const FPassFactoryRegistration GTonemap({
	.Type = "Tonemap",
	.Doc = "The film curve and sRGB, by the view's settings, without bloom.",
	.Inputs = {{"Input", PictureResource, "Linear, pre-exposed."}},
	.Parameters = {MakeExposureScaleSpec()},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FTonemapInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, Arguments.Values);
		return AddTonemapPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock

FScreenPassTexture Drydock::BuiltInAddTonemapPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	const bool bCompute =
		View.bUseComputePasses &&
		(!Inputs.OverrideOutput.IsValid() || EnumHasAnyFlags(Inputs.OverrideOutput.Texture->Desc.Flags, TexCreate_UAV));
	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid() ? Inputs.OverrideOutput : CreateOutput(GraphBuilder, Inputs, bCompute);
	FTonemapParameters Parameters = MakeParameters(GraphBuilder, View, Inputs, Output);
	FTonemapPermutation Permutation = ChoosePermutation(View, Inputs, Parameters);
	SetRemap(GraphBuilder, View, Inputs, Parameters, Permutation);

	const FString Name = FString::Printf(TEXT("Tonemap %dx%d"), Output.ViewRect.Width(), Output.ViewRect.Height());
	return Drydock::AddScreenShaderPass<FTonemapPS, FTonemapCS>(GraphBuilder, View, {Name, Output, bCompute},
		Parameters, Permutation, &FTonemapCS::FParameters::RWOutputTexture);
}
