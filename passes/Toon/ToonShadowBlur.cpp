// The passes of the toon-shadow blur. Source: article "Toon-shadow blur".
#include "Toon/ToonShadowBlur.h"

#include "Bloom/PostProcessGaussianBloom.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarToonShadowBlurAsPrinted(TEXT("r.ToonShadowBlur.AsPrinted"), 0,
	TEXT("1: as the article prints it: border addressing (the picture's edge darkens) and the raw screen. Default 0."),
	ECVF_RenderThreadSafe);

class FToonShadowSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FToonShadowSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FToonShadowSetupPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, ToonShadow)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonShadowTexture)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FToonShadowCombinePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FToonShadowCombinePS);
	SHADER_USE_PARAMETER_STRUCT(FToonShadowCombinePS, FGlobalShader);

	class FBlurredDimension : SHADER_PERMUTATION_BOOL("USE_BLURRED");
	class FStoreDimension : SHADER_PERMUTATION_INT("TOON_SHADOW_STORE", 3);
	using FPermutationDomain = TShaderPermutationDomain<FBlurredDimension, FStoreDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, ToonShadow)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Blurred)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonShadowTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BlurredSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FToonShadowLightingPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FToonShadowLightingPS);
	SHADER_USE_PARAMETER_STRUCT(FToonShadowLightingPS, FGlobalShader);

	class FBlendDimension : SHADER_PERMUTATION_INT("TOON_SHADOW_BLEND", 3);
	class FStoreDimension : SHADER_PERMUTATION_INT("TOON_SHADOW_STORE", 3);
	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");
	class FRampDimension : SHADER_PERMUTATION_BOOL("USE_RAMP");
	using FPermutationDomain =
		TShaderPermutationDomain<FBlendDimension, FStoreDimension, FAsPrintedDimension, FRampDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, ToonShadow)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonShadowTexture)
		SHADER_PARAMETER(FLinearColor, LightColor)
		SHADER_PARAMETER(float, Intensity)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, RampTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, RampSampler)
		SHADER_PARAMETER(FVector2f, RampScaleBias)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FToonShadowSetupPS, "/Project/ToonShadowBlur.usf", "SetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FToonShadowCombinePS, "/Project/ToonShadowBlur.usf", "CombinePS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FToonShadowLightingPS, "/Project/ToonShadowBlur.usf", "LightingPS", SF_Pixel);

FScreenPassTextureViewportParameters GetViewportOf(const FScreenPassTexture& Texture)
{
	return GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Texture));
}

} // namespace

FToonShadowBlurInputs FToonShadowBlurInputs::FromSettings(
	const FFinalPostProcessSettings& Settings, const FScreenPassTexture& ToonShadow)
{
	FToonShadowBlurInputs Inputs;
	Inputs.ToonShadow = ToonShadow;
	Inputs.Store = Settings.ToonShadowBlurStore;
	Inputs.bAsPrinted = CVarToonShadowBlurAsPrinted.GetValueOnRenderThread() != 0;
	Inputs.Blur.Stages = {
		{TEXT("ToonShadow6X"), TEXT("ToonShadow6Y"), Settings.ToonShadowBlur6Size, Settings.ToonShadowBlur6Tint},
		{TEXT("ToonShadow5X"), TEXT("ToonShadow5Y"), Settings.ToonShadowBlur5Size, Settings.ToonShadowBlur5Tint},
		{TEXT("ToonShadow4X"), TEXT("ToonShadow4Y"), Settings.ToonShadowBlur4Size, Settings.ToonShadowBlur4Tint},
		{TEXT("ToonShadow3X"), TEXT("ToonShadow3Y"), Settings.ToonShadowBlur3Size, Settings.ToonShadowBlur3Tint},
		{TEXT("ToonShadow2X"), TEXT("ToonShadow2Y"), Settings.ToonShadowBlur2Size, Settings.ToonShadowBlur2Tint},
		{TEXT("ToonShadow1X"), TEXT("ToonShadow1Y"), Settings.ToonShadowBlur1Size, Settings.ToonShadowBlur1Tint},
	};
	const int32 Quality = FMath::Clamp(Settings.ToonShadowBlurQuality, 1, static_cast<int32>(EBloomQuality::MAX) - 1);
	Inputs.Blur.StageCount = GetBloomStageCount(static_cast<EBloomQuality>(Quality));
	Inputs.Blur.SizeScale = Settings.ToonShadowBlurSizeScale;
	return Inputs;
}

FScreenPassTexture AddToonShadowSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& ToonShadow, EToonShadowBlurStore Store)
{
	check(ToonShadow.IsValid());
	const FScreenPassRenderTarget Output =
		CreateRasterTargetLike(GraphBuilder, ToonShadow, TEXT("ToonShadowSetup"), GetToonShadowBlurFormat(Store));

	auto* PassParameters = GraphBuilder.AllocParameters<FToonShadowSetupPS::FParameters>();
	PassParameters->ToonShadow = GetViewportOf(ToonShadow);
	PassParameters->Output = GetViewportOf(Output);
	PassParameters->ToonShadowTexture = ToonShadow.Texture;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	TShaderMapRef<FToonShadowSetupPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("ToonShadowSetup %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		PassParameters, Output.ViewRect);
	return Output;
}

FScreenPassTexture AddToonShadowCombinePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& ToonShadow, const FScreenPassTexture& Blurred, EToonShadowBlurStore Store)
{
	check(ToonShadow.IsValid());
	const FScreenPassRenderTarget Output = CreateRasterTargetLike(GraphBuilder, ToonShadow, TEXT("ToonShadowBlurred"));

	auto* PassParameters = GraphBuilder.AllocParameters<FToonShadowCombinePS::FParameters>();
	PassParameters->ToonShadow = GetViewportOf(ToonShadow);
	PassParameters->Output = GetViewportOf(Output);
	PassParameters->ToonShadowTexture = ToonShadow.Texture;
	if (Blurred.IsValid())
	{
		PassParameters->Blurred = GetViewportOf(Blurred);
		PassParameters->BlurredTexture = Blurred.Texture;
		PassParameters->BlurredSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	}
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FToonShadowCombinePS::FPermutationDomain Permutation;
	Permutation.Set<FToonShadowCombinePS::FBlurredDimension>(Blurred.IsValid());
	Permutation.Set<FToonShadowCombinePS::FStoreDimension>(static_cast<int32>(Store));
	TShaderMapRef<FToonShadowCombinePS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("ToonShadowCombine %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		PassParameters, Output.ViewRect);
	return Output;
}

FScreenPassTexture AddToonShadowBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonShadowBlurInputs& Inputs)
{
	check(Inputs.ToonShadow.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "ToonShadowBlur");

	FGaussianSumInputs Blur = Inputs.Blur;
	Blur.TintScale = GetNormalizingTintScale(Blur);
	Blur.bClampAddressing = !Inputs.bAsPrinted;
	const FScreenPassTexture Setup = AddToonShadowSetupPass(GraphBuilder, View, Inputs.ToonShadow, Inputs.Store);
	const FScreenPassTexture Blurred = AddTextureGaussianSumPasses(
		GraphBuilder, View, Setup, GetToonShadowBlurFormat(Inputs.Store), TEXT("ToonShadowDownsample"), Blur);
	return AddToonShadowCombinePass(GraphBuilder, View, Inputs.ToonShadow, Blurred, Inputs.Store);
}

FScreenPassTexture AddToonShadowLightingPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonShadowLightingInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.ToonShadow.IsValid());
	check(Inputs.SceneTextures);

	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid()
			? Inputs.OverrideOutput
			: CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("ToonShadowLighting"));

	auto* PassParameters = GraphBuilder.AllocParameters<FToonShadowLightingPS::FParameters>();
	PassParameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
	PassParameters->Color = GetViewportOf(Inputs.SceneColor);
	PassParameters->ToonShadow = GetViewportOf(Inputs.ToonShadow);
	PassParameters->Output = GetViewportOf(Output);
	PassParameters->ColorTexture = Inputs.SceneColor.Texture;
	PassParameters->ToonShadowTexture = Inputs.ToonShadow.Texture;
	PassParameters->LightColor = Inputs.LightColor;
	PassParameters->Intensity = Inputs.Intensity;
	const bool bRamp = Inputs.Ramp && Inputs.Blend == EToonShadowBlurBlend::Max;
	if (bRamp)
	{
		const float Width = static_cast<float>(Inputs.Ramp->GetSizeXY().X);
		PassParameters->RampTexture =
			GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Inputs.Ramp, TEXT("ToonShadowBlurRamp")));
		PassParameters->RampSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		PassParameters->RampScaleBias = FVector2f((Width - 1.0f) / Width, 0.5f / Width);
	}
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FToonShadowLightingPS::FPermutationDomain Permutation;
	Permutation.Set<FToonShadowLightingPS::FBlendDimension>(static_cast<int32>(Inputs.Blend));
	Permutation.Set<FToonShadowLightingPS::FStoreDimension>(static_cast<int32>(Inputs.Store));
	Permutation.Set<FToonShadowLightingPS::FAsPrintedDimension>(Inputs.bAsPrinted);
	Permutation.Set<FToonShadowLightingPS::FRampDimension>(bRamp);
	TShaderMapRef<FToonShadowLightingPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("ToonShadowLighting %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

float EncodeToonShadowBlur(float Blurred, EToonShadowBlurStore Store)
{
	return Store == EToonShadowBlurStore::SqrtEightBit ? std::sqrt(Blurred) : Blurred;
}

float DecodeToonShadowBlur(float Stored, EToonShadowBlurStore Store)
{
	return Store == EToonShadowBlurStore::SqrtEightBit ? Stored * Stored : Stored;
}

EPixelFormat GetToonShadowBlurFormat(EToonShadowBlurStore Store)
{
	return Store == EToonShadowBlurStore::EightBit ? PF_G8 : PF_R16F;
}

} // namespace Drydock
