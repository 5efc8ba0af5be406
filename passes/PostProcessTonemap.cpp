// Source: engine file PostProcessTonemap.cpp.
#include "PostProcessTonemap.h"

#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<float> CVarTonemapperGamma(TEXT("r.TonemapperGamma"), 0.0f,
	TEXT("0: the display's gamma of 2.2 (default); above 0: this one."), ECVF_Scalability | ECVF_RenderThreadSafe);

constexpr float DefaultDisplayGamma = 2.2f;

BEGIN_SHADER_PARAMETER_STRUCT(FTonemapParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Bloom)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BloomTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, BloomSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, SceneColorApplyParamaters)
	SHADER_PARAMETER(FLinearColor, ColorScale0)
	SHADER_PARAMETER(FVector4f, FilmSlopeToeShoulderBlackClip)
	SHADER_PARAMETER(float, FilmWhiteClip)
	SHADER_PARAMETER(float, BlueCorrection)
	SHADER_PARAMETER(float, ExpandGamut)
	SHADER_PARAMETER(float, ToneCurveAmount)
	SHADER_PARAMETER(FVector3f, InverseGamma)
	SHADER_PARAMETER(FVector2f, VignetteScale)
	SHADER_PARAMETER(float, VignetteIntensity)
	SHADER_PARAMETER(float, bWriteLumaToAlpha)
	SHADER_PARAMETER_STRUCT(FLocalExposureShaderParameters, LocalExposure)
END_SHADER_PARAMETER_STRUCT()

class FTonemapBloomDimension : SHADER_PERMUTATION_BOOL("USE_BLOOM");
class FTonemapVignetteDimension : SHADER_PERMUTATION_BOOL("USE_VIGNETTE");
class FTonemapLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");
class FTonemapSceneColorApplyDimension : SHADER_PERMUTATION_BOOL("USE_SCENE_COLOR_APPLY");

using FTonemapPermutation = TShaderPermutationDomain<FTonemapBloomDimension, FTonemapVignetteDimension,
	FTonemapLocalExposureDimension, FTonemapSceneColorApplyDimension>;

class FTonemapPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTonemapPS);
	SHADER_USE_PARAMETER_STRUCT(FTonemapPS, FGlobalShader);

	using FPermutationDomain = FTonemapPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FTonemapParameters, Tonemap)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FTonemapCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTonemapCS);
	SHADER_USE_PARAMETER_STRUCT(FTonemapCS, FGlobalShader);

	using FPermutationDomain = FTonemapPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FTonemapParameters, Tonemap)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, RWOutputTexture)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEX"), FComputeShaderUtils::kGolden2DGroupSize);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEY"), FComputeShaderUtils::kGolden2DGroupSize);
	}
};

IMPLEMENT_GLOBAL_SHADER(FTonemapPS, "/Engine/Private/PostProcessTonemap.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FTonemapCS, "/Engine/Private/PostProcessTonemap.usf", "MainCS", SF_Compute);

FScreenPassRenderTarget CreateOutput(FRDGBuilder& GraphBuilder, const FTonemapInputs& Inputs, bool bCompute)
{
	FRDGTextureDesc Desc = Inputs.SceneColor.Texture->Desc;
	Desc.Reset();
	Desc.Format = Inputs.OutputFormat;
	Desc.Flags &= ~(TexCreate_RenderTargetable | TexCreate_UAV);
	Desc.Flags |= TexCreate_ShaderResource | (bCompute ? TexCreate_UAV : TexCreate_RenderTargetable);
	Desc.ClearValue = FClearValueBinding(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f));
	return FScreenPassRenderTarget(GraphBuilder.CreateTexture(Desc, TEXT("Tonemap")), Inputs.SceneColor.ViewRect,
		ERenderTargetLoadAction::ENoAction);
}

FVector3f ComputeInverseGamma()
{
	const float TonemapperGamma = CVarTonemapperGamma.GetValueOnRenderThread();
	const float DisplayGamma = TonemapperGamma > 0.0f ? TonemapperGamma : DefaultDisplayGamma;
	return FVector3f(1.0f / DisplayGamma, 2.2f / DisplayGamma, 1.0f / FMath::Max(TonemapperGamma, 1.0f));
}

FTonemapParameters MakeParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs,
	const FScreenPassRenderTarget& Output)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	FRHISamplerState* const BilinearClamp = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	FTonemapParameters Parameters;
	Parameters.View = View.ViewUniformBuffer;
	Parameters.Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	Parameters.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters.ColorTexture = Inputs.SceneColor.Texture;
	Parameters.ColorSampler = BilinearClamp;
	if (Inputs.Bloom.IsValid())
	{
		Parameters.Bloom = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.Bloom));
		Parameters.BloomTexture = Inputs.Bloom.Texture;
		Parameters.BloomSampler = BilinearClamp;
	}
	Parameters.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	if (Inputs.SceneColorApplyParamaters)
	{
		Parameters.SceneColorApplyParamaters = GraphBuilder.CreateSRV(Inputs.SceneColorApplyParamaters);
	}
	Parameters.ColorScale0 = Settings.SceneColorTint;
	Parameters.FilmSlopeToeShoulderBlackClip =
		FVector4f(Settings.FilmSlope, Settings.FilmToe, Settings.FilmShoulder, Settings.FilmBlackClip);
	Parameters.FilmWhiteClip = Settings.FilmWhiteClip;
	Parameters.BlueCorrection = Settings.BlueCorrection;
	Parameters.ExpandGamut = Settings.ExpandGamut;
	Parameters.ToneCurveAmount = Settings.ToneCurveAmount;
	Parameters.InverseGamma = ComputeInverseGamma();
	Parameters.VignetteScale = Drydock::ComputeVignetteScale(Output.ViewRect.Size());
	Parameters.VignetteIntensity = Settings.VignetteIntensity;
	Parameters.bWriteLumaToAlpha = Inputs.bWriteAlphaChannel ? 1.0f : 0.0f;
	Parameters.LocalExposure = GetLocalExposureShaderParameters(Inputs.LocalExposure);
	return Parameters;
}

} // namespace

namespace Drydock
{

FVector2f ComputeVignetteScale(FIntPoint ViewSize)
{
	const float HeightOverWidth = static_cast<float>(ViewSize.Y) / static_cast<float>(ViewSize.X);
	const float Scale = std::sqrt(2.0f) / std::sqrt(1.0f + HeightOverWidth * HeightOverWidth);
	return FVector2f(Scale, Scale * HeightOverWidth);
}

} // namespace Drydock

FScreenPassTexture AddTonemapPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTonemapInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	const bool bCompute =
		View.bUseComputePasses &&
		(!Inputs.OverrideOutput.IsValid() || EnumHasAnyFlags(Inputs.OverrideOutput.Texture->Desc.Flags, TexCreate_UAV));
	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid() ? Inputs.OverrideOutput : CreateOutput(GraphBuilder, Inputs, bCompute);
	const FTonemapParameters Parameters = MakeParameters(GraphBuilder, View, Inputs, Output);

	FTonemapPermutation Permutation;
	Permutation.Set<FTonemapBloomDimension>(Inputs.Bloom.IsValid());
	Permutation.Set<FTonemapSceneColorApplyDimension>(Inputs.SceneColorApplyParamaters != nullptr);
	Permutation.Set<FTonemapVignetteDimension>(View.FinalPostProcessSettings.VignetteIntensity > 0.0f);
	Permutation.Set<FTonemapLocalExposureDimension>(Inputs.LocalExposure.IsValid());

	const int32 Width = Output.ViewRect.Width();
	const int32 Height = Output.ViewRect.Height();
	if (bCompute)
	{
		FTonemapCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FTonemapCS::FParameters>();
		PassParameters->Tonemap = Parameters;
		PassParameters->RWOutputTexture = GraphBuilder.CreateUAV(Output.Texture);

		TShaderMapRef<FTonemapCS> ComputeShader(View.ShaderMap, Permutation);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Tonemap %dx%d (CS)", Width, Height), ComputeShader,
			PassParameters,
			FComputeShaderUtils::GetGroupCount(FIntPoint(Width, Height), FComputeShaderUtils::kGolden2DGroupSize));
	}
	else
	{
		FTonemapPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FTonemapPS::FParameters>();
		PassParameters->Tonemap = Parameters;
		PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

		TShaderMapRef<FTonemapPS> PixelShader(View.ShaderMap, Permutation);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
			RDG_EVENT_NAME("Tonemap %dx%d (PS)", Width, Height), PixelShader, PassParameters, Output.ViewRect);
	}

	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}
