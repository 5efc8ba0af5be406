// The passes: halved PassNum times from the picture's own size on, then doubled as often, sizes as integers, in compute
// shaders with point samplers, as the article has it. Its headers are all that is included.
#include "DualKawaseBlur.h"

#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterial.h"
#include "PostProcess/PostProcessing.h"
#include "RenderGraphEvent.h"
#include "ShaderParameterStruct.h"

namespace
{

constexpr int32 GroupSize = 32;

void DefineGroup(FShaderCompilerEnvironment& OutEnvironment)
{
	OutEnvironment.SetDefine(TEXT("NUMTHREADS_X"), GroupSize);
	OutEnvironment.SetDefine(TEXT("NUMTHREADS_Y"), GroupSize);
}

} // namespace

class FDualKawaseBlurDCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FDualKawaseBlurDCS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseBlurDCS, FGlobalShader);

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		DefineGroup(OutEnvironment);
	}

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, ViewSize)
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Intexture)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};

class FDualKawaseBlurUCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FDualKawaseBlurUCS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseBlurUCS, FGlobalShader);

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		DefineGroup(OutEnvironment);
	}

	// The same parameters in another order.
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, ViewSize)
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Intexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FDualKawaseBlurDCS, "/ProjectS/DualKawaseBlur.usf", "DownSampleCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FDualKawaseBlurUCS, "/ProjectS/DualKawaseBlur.usf", "UpSampleCS", SF_Compute);

namespace
{

/** One pass from Source to a new texture that Desc describes. */
template<typename TShader>
FScreenPassRenderTarget AddBlurPass(FRDGBuilder& GraphBuilder, const FSceneView& View, FRDGTextureRef Source,
	const FRDGTextureDesc& Desc, float Offset, const TCHAR* Name)
{
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	const FScreenPassRenderTarget Target(GraphBuilder.CreateTexture(Desc, Name), ERenderTargetLoadAction::ELoad);
	const FRDGTextureUAVRef TargetUAV = GraphBuilder.CreateUAV(Target.Texture);

	auto* PassParameters = GraphBuilder.AllocParameters<typename TShader::FParameters>();
	PassParameters->ViewSize = FVector4f(Desc.Extent.X, Desc.Extent.Y, Offset, 0);
	PassParameters->View = View.ViewUniformBuffer;
	PassParameters->Intexture = Source;
	PassParameters->Sampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->OutTexture = TargetUAV;
	const FIntPoint Extent = TargetUAV->Desc.Texture->Desc.Extent;
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("%s %dx%d (CS)", Name, Extent.X, Extent.Y),
		TShaderMapRef<TShader>(ViewInfo.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(Desc.Extent, FIntPoint(GroupSize, GroupSize)));
	return Target;
}

} // namespace

FDualKawaseBlur::FDualKawaseBlur(const FAutoRegister& AutoRegister, float InOffset, int InPassNum, bool InUseGaussian)
	: FSceneViewExtensionBase(AutoRegister)
	, Offset(InOffset)
	, PassNum(InPassNum)
{
}

void FDualKawaseBlur::SubscribeToPostProcessingPass(
	EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
{
	if (Pass == EPostProcessingPass::MotionBlur)
	{
		InOutPassCallbacks.Add(
			FAfterPassCallbackDelegate::CreateRaw(this, &FDualKawaseBlur::PostProcessPassAfterTonemap_RenderThread));
	}
}

FScreenPassTexture FDualKawaseBlur::PostProcessPassAfterTonemap_RenderThread(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& InOutInputs)
{
	FScreenPassTexture Picture = InOutInputs.Textures[(uint32)EPostProcessMaterialInput::SceneColor];
	FRDGTextureDesc Desc = Picture.Texture->Desc;
	Desc.Flags = ETextureCreateFlags::UAV;

	RDG_EVENT_SCOPE(GraphBuilder, "DualKawaseBlurCompute");
	for (int Pass = 0; Pass < PassNum; ++Pass)
	{
		Picture =
			AddBlurPass<FDualKawaseBlurDCS>(GraphBuilder, View, Picture.Texture, Desc, Offset, TEXT("ArticleDownPass"));
		Desc.Extent = FIntPoint(Desc.Extent.X / 2, Desc.Extent.Y / 2);
	}
	for (int Pass = 0; Pass < PassNum; ++Pass)
	{
		Desc.Extent = FIntPoint(Desc.Extent.X * 2, Desc.Extent.Y * 2);
		Picture =
			AddBlurPass<FDualKawaseBlurUCS>(GraphBuilder, View, Picture.Texture, Desc, Offset, TEXT("ArticleUpPass"));
	}
	return MoveTemp(Picture);
}
