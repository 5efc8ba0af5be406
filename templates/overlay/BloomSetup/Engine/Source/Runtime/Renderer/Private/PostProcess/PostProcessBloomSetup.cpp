// The pass of the bloom setup, in the form of the engine's file of this name.
#include "PostProcess/PostProcessBloomSetup.h"

#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture3D, LumBilateralGrid)
	SHADER_PARAMETER_SAMPLER(SamplerState, LumBilateralGridSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredLogLum)
	SHADER_PARAMETER_SAMPLER(SamplerState, BlurredLogLumSampler)
	SHADER_PARAMETER_STRUCT(FLocalExposureParameters, LocalExposure)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, EyeAdaptation)
	SHADER_PARAMETER(float, BloomThreshold)
END_SHADER_PARAMETER_STRUCT()

FBloomSetupParameters GetBloomSetupParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTextureViewport& InputViewport, const FBloomSetupInputs& Inputs)
{
	FRHISamplerState* BilinearClampSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	FBloomSetupParameters Parameters;
	Parameters.View = View.ViewUniformBuffer;
	Parameters.Input = GetScreenPassTextureViewportParameters(InputViewport);
	Parameters.InputTexture = Inputs.SceneColor.Texture;
	Parameters.InputSampler = BilinearClampSampler;
	Parameters.LumBilateralGrid = Inputs.LocalExposureTexture;
	Parameters.LumBilateralGridSampler = BilinearClampSampler;
	Parameters.BlurredLogLum = Inputs.BlurredLogLuminanceTexture;
	Parameters.BlurredLogLumSampler = BilinearClampSampler;
	Parameters.LocalExposure = *Inputs.LocalExposureParameters;
	Parameters.EyeAdaptationBuffer = GraphBuilder.CreateSRV(Inputs.EyeAdaptationBuffer);
	Parameters.EyeAdaptation = *Inputs.EyeAdaptationParameters;
	Parameters.BloomThreshold = Inputs.Threshold;
	return Parameters;
}

class FLocalExposureDim : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");
class FThresholdDim : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");
using FBloomSetupPermutation = TShaderPermutationDomain<FLocalExposureDim, FThresholdDim>;

class FBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupPS, FGlobalShader);

	using FPermutationDomain = FBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, BloomSetup)
		SHADER_PARAMETER(FScreenTransform, SvPositionToInputTextureUV)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FBloomSetupCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupCS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupCS, FGlobalShader);

	using FPermutationDomain = FBloomSetupPermutation;

	static constexpr uint32 ThreadGroupSize = 8;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, BloomSetup)
		SHADER_PARAMETER(FScreenTransform, SvPositionToInputTextureUV)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, BloomOutput)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEX"), ThreadGroupSize);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEY"), ThreadGroupSize);
	}
};

IMPLEMENT_GLOBAL_SHADER(FBloomSetupPS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FBloomSetupCS, "/Engine/Private/PostProcessBloom.usf", "BloomSetupCS", SF_Compute);

} // namespace

FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);

	const bool bIsComputePass = View.bUseComputePasses;

	FRDGTextureDesc OutputDesc = Inputs.SceneColor.Texture->Desc;
	OutputDesc.Reset();
	OutputDesc.Flags |= bIsComputePass ? TexCreate_UAV : TexCreate_RenderTargetable;
	OutputDesc.Flags &= bIsComputePass ? ~TexCreate_RenderTargetable : ~TexCreate_UAV;
	const FScreenPassRenderTarget Output(GraphBuilder.CreateTexture(OutputDesc, TEXT("BloomSetup")),
		Inputs.SceneColor.ViewRect, ERenderTargetLoadAction::ENoAction);

	const FScreenPassTextureViewport Viewport(Inputs.SceneColor);
	const FBloomSetupParameters SetupParameters = GetBloomSetupParameters(GraphBuilder, View, Viewport, Inputs);
	const FScreenTransform SvPositionToInputTextureUV =
		FScreenTransform::SvPositionToViewportUV(Output.ViewRect) * FScreenTransform::ChangeTextureBasisFromTo(Viewport,
																		FScreenTransform::ETextureBasis::ViewportUV,
																		FScreenTransform::ETextureBasis::TextureUV);

	FBloomSetupPermutation PermutationVector;
	PermutationVector.Set<FLocalExposureDim>(Inputs.LocalExposureTexture != nullptr);
	PermutationVector.Set<FThresholdDim>(Inputs.Threshold > -1.0f);

	if (bIsComputePass)
	{
		FBloomSetupCS::FParameters* PassParameters = GraphBuilder.AllocParameters<FBloomSetupCS::FParameters>();
		PassParameters->BloomSetup = SetupParameters;
		PassParameters->SvPositionToInputTextureUV = SvPositionToInputTextureUV;
		PassParameters->BloomOutput = GraphBuilder.CreateUAV(Output.Texture);

		TShaderMapRef<FBloomSetupCS> ComputeShader(View.ShaderMap, PermutationVector);
		FComputeShaderUtils::AddPass(GraphBuilder,
			RDG_EVENT_NAME("BloomSetup %dx%d (CS)", Output.ViewRect.Width(), Output.ViewRect.Height()), ComputeShader,
			PassParameters, FComputeShaderUtils::GetGroupCount(Output.ViewRect.Size(), FBloomSetupCS::ThreadGroupSize));
	}
	else
	{
		FBloomSetupPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FBloomSetupPS::FParameters>();
		PassParameters->BloomSetup = SetupParameters;
		PassParameters->SvPositionToInputTextureUV = SvPositionToInputTextureUV;
		PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

		TShaderMapRef<FBloomSetupPS> PixelShader(View.ShaderMap, PermutationVector);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
			RDG_EVENT_NAME("BloomSetup %dx%d (PS)", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
			PassParameters, Output.ViewRect);
	}

	return FScreenPassTexture(Output);
}
