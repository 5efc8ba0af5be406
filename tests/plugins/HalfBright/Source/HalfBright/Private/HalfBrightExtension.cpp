#include "HalfBrightExtension.h"

#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"

DECLARE_GPU_STAT_NAMED(HalfBright, TEXT("Half bright"));

namespace HalfBright
{

BEGIN_SHADER_PARAMETER_STRUCT(FPassParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER(FVector2f, InvExtent)
	SHADER_PARAMETER(FLinearColor, Tint)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FHalfBrightPS final : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FHalfBrightPS)
	using FParameters = FPassParameters;
	SHADER_USE_PARAMETER_STRUCT(FHalfBrightPS, FGlobalShader)
};

IMPLEMENT_GLOBAL_SHADER(FHalfBrightPS, "/HalfBrightShaders/HalfBright.usf", "MainPS", SF_Pixel)

} // namespace HalfBright

FHalfBrightExtension::FHalfBrightExtension(const FAutoRegister& AutoRegister, float InScale)
	: FSceneViewExtensionBase(AutoRegister)
	, Scale(InScale)
{
}

void FHalfBrightExtension::SubscribeToPostProcessingPass(
	EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
{
	if (Pass == EPostProcessingPass::MotionBlur)
	{
		InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FHalfBrightExtension::Render_RenderThread));
	}
}

FScreenPassTexture FHalfBrightExtension::Render_RenderThread(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	checkSlow(View.bIsViewInfo);
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	RDG_GPU_STAT_SCOPE(GraphBuilder, HalfBright)
	RDG_EVENT_SCOPE(GraphBuilder, "HalfBright %s", *FString::FromInt(1));

	const FScreenPassTexture SceneColor(
		(FScreenPassTextureSlice)Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	const FRDGTextureDesc OutputDesc = FRDGTextureDesc::Create2D(SceneColor.Texture->Desc.Extent, PF_FloatRGBA,
		FClearValueBinding::Black, TexCreate_ShaderResource | TexCreate_RenderTargetable);
	FRDGTexture* OutputTexture = GraphBuilder.CreateTexture(OutputDesc, TEXT("HalfBright.Output"));

	HalfBright::FPassParameters* Parameters = GraphBuilder.AllocParameters<HalfBright::FPassParameters>();
	Parameters->View = View.ViewUniformBuffer;
	Parameters->InputTexture = SceneColor.Texture;
	Parameters->InputSampler = TStaticSamplerState<>::GetRHI();
	Parameters->InvExtent = FVector2f(1.0f, 1.0f) / FVector2f(SceneColor.Texture->Desc.Extent);
	Parameters->Tint = FLinearColor(Scale, Scale, Scale, 1.0f);
	Parameters->RenderTargets[0] = FRenderTargetBinding(OutputTexture, ERenderTargetLoadAction::ENoAction);

	TShaderMapRef<HalfBright::FHalfBrightPS> PixelShader(ViewInfo.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, ViewInfo.ShaderMap, RDG_EVENT_NAME("HalfBright"), PixelShader, Parameters, SceneColor.ViewRect);
	return FScreenPassTexture(OutputTexture, SceneColor.ViewRect);
}
