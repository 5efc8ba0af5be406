// The pass of FXAA. Source: engine file PostProcessAA.cpp.
#include "Screen/PostProcessAA.h"

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

TAutoConsoleVariable<int32> CVarFXAAQuality(TEXT("r.FXAA.Quality"), 4,
	TEXT("Steps of the search along edges: 0 none, 1 three, 2 five, 3 eight, 4 twelve (default), 5 twelve shorter "
		 "ones."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

class FFXAAQualityDimension : SHADER_PERMUTATION_ENUM_CLASS("FXAA_PRESET", EFXAAQuality);
class FFXAALumaDimension : SHADER_PERMUTATION_BOOL("LUMA_IN_ALPHA");

class FFXAAPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FFXAAPS);
	SHADER_USE_PARAMETER_STRUCT(FFXAAPS, FGlobalShader);

	using FPermutationDomain = TShaderPermutationDomain<FFXAAQualityDimension, FFXAALumaDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER(float, Subpix)
		SHADER_PARAMETER(float, EdgeThreshold)
		SHADER_PARAMETER(float, EdgeThresholdMin)
		SHADER_PARAMETER(float, EdgeSharpness)
		SHADER_PARAMETER(float, SampleSteps)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FFXAAPS, "/Engine/Private/FXAAShader.usf", "MainPS", SF_Pixel);

} // namespace

EFXAAQuality GetFXAAQuality()
{
	return static_cast<EFXAAQuality>(
		FMath::Clamp(CVarFXAAQuality.GetValueOnRenderThread(), 0, static_cast<int32>(EFXAAQuality::MAX) - 1));
}

FScreenPassTexture Drydock::BuiltInAddFXAAPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFXAAInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid()
			? Inputs.OverrideOutput
			: Drydock::CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("FXAA"));
	const bool bConsole = Inputs.Quality == EFXAAQuality::Q0;

	FFXAAPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FFXAAPS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = Inputs.SceneColor.Texture;
	PassParameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Subpix = 0.75f;
	PassParameters->EdgeThreshold = bConsole ? 0.125f : 0.166f;
	PassParameters->EdgeThresholdMin = bConsole ? 0.05f : 0.0833f;
	PassParameters->EdgeSharpness = 8.0f;
	PassParameters->SampleSteps = static_cast<float>(Drydock::GetSampleSteps());
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FFXAAPS::FPermutationDomain Permutation;
	Permutation.Set<FFXAAQualityDimension>(Inputs.Quality);
	Permutation.Set<FFXAALumaDimension>(Inputs.bLumaInAlpha);
	TShaderMapRef<FFXAAPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("FXAA(Quality=%d) %dx%d", static_cast<int32>(Inputs.Quality), Output.ViewRect.Width(),
			Output.ViewRect.Height()),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}
