// Source: engine file PostProcessBloomSetup.cpp.
#include "PostProcessBloomSetup.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER(float, BloomThreshold)
END_SHADER_PARAMETER_STRUCT()

class FThresholdDimension : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");

class FBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupPS, FGlobalShader);

	using FPermutationDomain = TShaderPermutationDomain<FThresholdDimension>;

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

	using FPermutationDomain = TShaderPermutationDomain<FThresholdDimension>;

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

} // namespace

FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	const bool bCompute = View.bUseComputePasses;

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

	// Written so that a NaN threshold, which no comparison holds for, means none.
	const bool bUseThreshold = Inputs.Threshold > -1.0f;

	if (bCompute)
	{
		FBloomSetupCS::FPermutationDomain Permutation;
		Permutation.Set<FThresholdDimension>(bUseThreshold);
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
		FBloomSetupPS::FPermutationDomain Permutation;
		Permutation.Set<FThresholdDimension>(bUseThreshold);
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
