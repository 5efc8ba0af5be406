// The pass that keeps what is bright enough to bloom, and its factory. Source: engine file PostProcessBloomSetup.cpp.
#include "Bloom/PostProcessBloomSetup.h"

#include "Bloom/BloomSetupShaders.h"
#include "Exposure/ExposureFactory.h"
#include "PassFactory.h"
#include "PassFunctions.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"

#include <cmath>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FBloomSetupPS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FBloomSetupCS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupCS", SF_Compute);

FBloomSetupPS::FPermutationDomain ChooseBloomSetupPermutation(
	const FViewInfo& View, float Threshold, bool bLocalExposure)
{
	FBloomSetupPS::FPermutationDomain Permutation;
	// No comparison holds for NaN.
	Permutation.Set<FThresholdDimension>(
		Threshold > -1.0f || (View.EngineProfile.bBloomRampWithoutThreshold && std::isfinite(Threshold)));
	Permutation.Set<FLocalExposureDimension>(bLocalExposure);
	return Permutation;
}

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

Drydock::FBloomSetupParameters Drydock::GetBloomSetupParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTextureViewport& InputViewport, const FBloomSetupInputs& Inputs)
{
	FRHISamplerState* const BilinearClamp = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	FBloomSetupParameters Parameters;
	Parameters.View = View.ViewUniformBuffer;
	Parameters.Input = GetScreenPassTextureViewportParameters(InputViewport);
	Parameters.InputTexture = Inputs.SceneColor.Texture;
	Parameters.InputSampler = BilinearClamp;
	Parameters.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	Parameters.BloomThreshold = Inputs.Threshold;
	Parameters.SvPositionToInputTextureUV =
		FScreenTransform::SvPositionToViewportUV(InputViewport.Rect) *
		FScreenTransform::ChangeTextureBasisFromTo(
			InputViewport, FScreenTransform::ETextureBasis::ViewportUV, FScreenTransform::ETextureBasis::TextureUV);
	if (Inputs.LocalExposureTexture)
	{
		check(Inputs.EyeAdaptationParameters && Inputs.LocalExposureParameters && Inputs.BlurredLogLuminanceTexture);
		Parameters.EyeAdaptation = *Inputs.EyeAdaptationParameters;
		Parameters.LocalExposure = *Inputs.LocalExposureParameters;
		Parameters.LumBilateralGrid = Inputs.LocalExposureTexture;
		Parameters.LumBilateralGridSampler = BilinearClamp;
		Parameters.BlurredLogLum = Inputs.BlurredLogLuminanceTexture;
		Parameters.BlurredLogLumSampler = BilinearClamp;
	}
	return Parameters;
}

FScreenPassTexture Drydock::BuiltInAddBloomSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	const bool bCompute = View.bUseComputePasses;
	const FScreenPassRenderTarget Output = Drydock::CreateScreenTarget(
		GraphBuilder, Inputs.SceneColor.Texture->Desc, Inputs.SceneColor.ViewRect, TEXT("BloomSetup"), bCompute);
	const FString Name = FString::Printf(TEXT("BloomSetup %dx%d"), Output.ViewRect.Width(), Output.ViewRect.Height());
	return Drydock::AddScreenShaderPass<Drydock::FBloomSetupPS, Drydock::FBloomSetupCS>(GraphBuilder, View,
		{Name, Output, bCompute},
		GetBloomSetupParameters(GraphBuilder, View, FScreenPassTextureViewport(Inputs.SceneColor), Inputs),
		Drydock::ChooseBloomSetupPermutation(View, Inputs.Threshold, Inputs.LocalExposureTexture != nullptr),
		&Drydock::FBloomSetupCS::FParameters::BloomOutput);
}
