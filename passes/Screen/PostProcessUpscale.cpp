// The pass that scales the picture at the end of the chain. Source: engine file PostProcessUpscale.cpp.
#include "Screen/PostProcessUpscale.h"

#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/SampleSteps.h"
#include "ShaderParameterStruct.h"

namespace
{

TAutoConsoleVariable<int32> CVarUpscaleQuality(TEXT("r.Upscale.Quality"), 3,
	TEXT("Filter of the upscale: 0 nearest, 1 bilinear, 2 directional, 3 Catmull-Rom (default), 4 Lanczos, 5 Gaussian "
		 "with unsharp mask."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarUpscaleSoftness(TEXT("r.Upscale.Softness"), 1.0f,
	TEXT("Amount of sharpening of filter 5, 0 to 1; 1 by default."), ECVF_Scalability | ECVF_RenderThreadSafe);

class FUpscaleMethodDimension : SHADER_PERMUTATION_ENUM_CLASS("UPSCALE_METHOD", EUpscaleMethod);

class FUpscalePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FUpscalePS);
	SHADER_USE_PARAMETER_STRUCT(FUpscalePS, FGlobalShader);

	using FPermutationDomain = TShaderPermutationDomain<FUpscaleMethodDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER(float, Softness)
		SHADER_PARAMETER(float, SampleSteps)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FUpscalePS, "/Engine/Private/PostProcessUpscale.usf", "MainPS", SF_Pixel);

const TCHAR* ToString(EUpscaleMethod Method)
{
	static const TCHAR* const Names[] = {
		TEXT("Nearest"), TEXT("Bilinear"), TEXT("Directional"), TEXT("CatmullRom"), TEXT("Lanczos"), TEXT("Gaussian")};
	return Names[static_cast<size_t>(Method)];
}

} // namespace

EUpscaleMethod GetUpscaleMethod()
{
	return static_cast<EUpscaleMethod>(
		FMath::Clamp(CVarUpscaleQuality.GetValueOnRenderThread(), 0, static_cast<int32>(EUpscaleMethod::MAX) - 1));
}

FScreenPassTexture Drydock::BuiltInAddUpscalePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUpscaleInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	const FScreenPassRenderTarget Output = Inputs.OverrideOutput.IsValid()
											   ? Inputs.OverrideOutput
											   : Drydock::CreateSmallRasterTarget(GraphBuilder, Inputs.SceneColor,
													 Inputs.OutputSize, TEXT("PrimaryUpscale"));
	const FIntPoint From = Inputs.SceneColor.ViewRect.Size(), To = Output.ViewRect.Size();

	FUpscalePS::FParameters* PassParameters = GraphBuilder.AllocParameters<FUpscalePS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = Inputs.SceneColor.Texture;
	PassParameters->InputSampler = Inputs.Method == EUpscaleMethod::Nearest
									   ? TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()
									   : TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Softness = FMath::Clamp(CVarUpscaleSoftness.GetValueOnRenderThread(), 0.0f, 1.0f);
	PassParameters->SampleSteps = static_cast<float>(Drydock::GetSampleSteps());
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FUpscalePS::FPermutationDomain Permutation;
	Permutation.Set<FUpscaleMethodDimension>(Inputs.Method);
	TShaderMapRef<FUpscalePS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("PrimaryUpscale(%s) %dx%d -> %dx%d", ::ToString(Inputs.Method), From.X, From.Y, To.X, To.Y),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}
