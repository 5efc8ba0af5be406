// Source: engine file PostProcessBloomSetup.cpp; toon bloom: the article's patch of it, and its correction.
#include "Bloom/PostProcessBloomSetup.h"

#include "Bloom/PostProcessToonBloom.h"
#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/DrawRegion.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace
{

enum class EToonBloom : uint8
{
	None,
	Corrected,
	AsPrinted,
	MAX
};

BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER(float, BloomThreshold)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
	SHADER_PARAMETER(float, ToonIntensity)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Toon)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonTexture)
	SHADER_PARAMETER_STRUCT(FLocalExposureShaderParameters, LocalExposure)
END_SHADER_PARAMETER_STRUCT()

class FThresholdDimension : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");
class FToonBloomDimension : SHADER_PERMUTATION_ENUM_CLASS("TOON_BLOOM", EToonBloom);
class FLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");

using FBloomSetupPermutation =
	TShaderPermutationDomain<FThresholdDimension, FToonBloomDimension, FLocalExposureDimension>;

class FBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupPS, FGlobalShader);

	using FPermutationDomain = FBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, BloomSetup)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FBloomSetupCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupCS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupCS, FGlobalShader);

	using FPermutationDomain = FBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, BloomSetup)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, BloomOutput)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEX"), FComputeShaderUtils::kGolden2DGroupSize);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEY"), FComputeShaderUtils::kGolden2DGroupSize);
	}
};

IMPLEMENT_GLOBAL_SHADER(FBloomSetupPS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FBloomSetupCS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupCS", SF_Compute);

/** The patch is in the pixel shader alone, as printed: compute loses it. */
EToonBloom ChooseToonBloom(const FBloomSetupInputs& Inputs, bool bCompute)
{
	if (!Inputs.SceneTextures)
	{
		return EToonBloom::None;
	}
	if (!IsToonBloomAsPrinted())
	{
		return EToonBloom::Corrected;
	}
	return bCompute ? EToonBloom::None : EToonBloom::AsPrinted;
}

/** Colour at the resolution of the ids. */
FScreenPassTexture FindFullResolution(const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	if (Inputs.FullResolutionSceneColor.IsValid())
	{
		return Inputs.FullResolutionSceneColor;
	}
	const FRDGTextureRef SceneColor = Inputs.SceneTextures->GetContents()->SceneColorTexture;
	const FIntPoint Extent = SceneColor ? SceneColor->Desc.Extent : FIntPoint(0, 0);
	const bool bHoldsView = Extent.X >= View.ViewRect.Max.X && Extent.Y >= View.ViewRect.Max.Y;
	const bool bIsInput = Inputs.SceneColor.ViewRect.Size() == View.ViewRect.Size();
	return bHoldsView && !bIsInput ? FScreenPassTexture(SceneColor, View.ViewRect) : Inputs.SceneColor;
}

/** The setup's input, over which what toon pixels reach is drawn with the factor in it. */
FScreenPassTexture AddToonColorWithin(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs,
	const FToonBloomInputs& MaskInputs)
{
	// A downsampled texel reads at most three texels around its place; one more for the rounding of the scale.
	constexpr int32 Reach = 4;
	const FIntRect& Full = MaskInputs.SceneColor.ViewRect;
	const FIntRect& Half = Inputs.SceneColor.ViewRect;
	const FIntRect Reached = Drydock::GrowRect(
		Drydock::ScaleRectOutward(Drydock::GrowRect(*Inputs.ToonBounds, Reach, Reach), Full.Size(), Half.Size()), 1, 1);
	FIntRect Drawn = Drydock::PlaceRect(Reached, Half);
	const FIntRect Read =
		Drydock::GrowRect(Drydock::ScaleRectOutward(Drawn - Half.Min, Half.Size(), Full.Size()), Reach, Reach);
	const FScreenPassTexture Masked =
		AddToonBloomMaskPass(GraphBuilder, View, MaskInputs, Drydock::PlaceRect(Read, Full));

	FScreenPassRenderTarget Output =
		Drydock::CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("ToonBloomHalfResolution"));
	AddCopyTexturePass(GraphBuilder, Inputs.SceneColor.Texture, Output.Texture, Half.Min, Half.Min, Half.Size());
	if (Full.Size() == Half.Size())
	{
		Drawn = Drydock::PlaceRect(*Inputs.ToonBounds, Half);
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
	FToonBloomInputs MaskInputs;
	MaskInputs.SceneColor = FindFullResolution(View, Inputs);
	MaskInputs.SceneTextures = Inputs.SceneTextures;
	MaskInputs.ToonIntensity = Inputs.ToonIntensity;
	if (Inputs.ToonBounds && !View.bUseComputePasses)
	{
		return AddToonColorWithin(GraphBuilder, View, Inputs, MaskInputs);
	}
	const FScreenPassTexture Masked = AddToonBloomMaskPass(GraphBuilder, View, MaskInputs);
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

FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	check(Inputs.ToonIntensity > -1.0f);

	const bool bCompute = View.bUseComputePasses;
	const EToonBloom ToonBloom = ChooseToonBloom(Inputs, bCompute);

	FRDGTextureDesc OutputDesc = Inputs.SceneColor.Texture->Desc;
	OutputDesc.Reset();
	OutputDesc.Flags &= ~(TexCreate_RenderTargetable | TexCreate_UAV);
	OutputDesc.Flags |= TexCreate_ShaderResource | (bCompute ? TexCreate_UAV : TexCreate_RenderTargetable);
	const FScreenPassRenderTarget Output(GraphBuilder.CreateTexture(OutputDesc, TEXT("BloomSetup")),
		Inputs.SceneColor.ViewRect, ERenderTargetLoadAction::ENoAction);

	const FScreenPassTextureViewport Viewport(Inputs.SceneColor);

	FBloomSetupParameters BloomSetup;
	BloomSetup.View = View.ViewUniformBuffer;
	BloomSetup.Input = GetScreenPassTextureViewportParameters(Viewport);
	BloomSetup.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	BloomSetup.InputTexture = Inputs.SceneColor.Texture;
	BloomSetup.InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	BloomSetup.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	BloomSetup.BloomThreshold = Inputs.Threshold;
	BloomSetup.LocalExposure = GetLocalExposureShaderParameters(Inputs.LocalExposure);

	BloomSetup.SceneTextures = Inputs.SceneTextures;
	BloomSetup.ToonIntensity = Inputs.ToonIntensity;
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

	if (bCompute)
	{
		TShaderMapRef<FBloomSetupCS> ComputeShader(View.ShaderMap, Permutation);

		FBloomSetupCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FBloomSetupCS::FParameters>();
		PassParameters->BloomSetup = BloomSetup;
		PassParameters->BloomOutput = GraphBuilder.CreateUAV(Output.Texture);

		FComputeShaderUtils::AddPass(GraphBuilder,
			RDG_EVENT_NAME("BloomSetup %dx%d (CS)", Output.ViewRect.Width(), Output.ViewRect.Height()), ComputeShader,
			PassParameters,
			FComputeShaderUtils::GetGroupCount(Output.ViewRect.Size(), FComputeShaderUtils::kGolden2DGroupSize));
	}
	else
	{
		TShaderMapRef<FBloomSetupPS> PixelShader(View.ShaderMap, Permutation);

		FBloomSetupPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FBloomSetupPS::FParameters>();
		PassParameters->BloomSetup = BloomSetup;
		PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
			RDG_EVENT_NAME("BloomSetup %dx%d (PS)", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
			PassParameters, Output.ViewRect);
	}

	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}
