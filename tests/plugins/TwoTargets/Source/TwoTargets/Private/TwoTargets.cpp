// Several render targets: one pass writes two, another subtracts one from the other.
#include "CoreMinimal.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterial.h"
#include "SceneViewExtension.h"

namespace
{

class FTwoTargetsPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTwoTargetsPS);
	SHADER_USE_PARAMETER_STRUCT(FTwoTargetsPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FTwoTargetsPS, "/Plugin/TwoTargets/TwoTargets.usf", "SplitPS", SF_Pixel);

class FSubtractPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FSubtractPS);
	SHADER_USE_PARAMETER_STRUCT(FSubtractPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Minuend)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Subtrahend)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FSubtractPS, "/Plugin/TwoTargets/TwoTargets.usf", "SubtractPS", SF_Pixel);

/** Fills a full-screen pass of any of these shaders. */
template<typename TShader, typename TSetup>
void AddTargetsPass(FRDGBuilder& GraphBuilder, const FSceneView& View, FIntRect Rect, TSetup&& Setup)
{
	FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.GetFeatureLevel());
	typename TShader::FParameters* Parameters = GraphBuilder.AllocParameters<typename TShader::FParameters>();
	Setup(Parameters);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, ShaderMap, RDG_EVENT_NAME("Targets"), TShaderMapRef<TShader>(ShaderMap), Parameters, Rect);
}

} // namespace

class FTwoTargetsExtension : public FSceneViewExtensionBase
{
public:
	FTwoTargetsExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FTwoTargetsExtension::Run));
		}
	}

	FScreenPassTexture Run(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor = Inputs.Textures[(uint32)EPostProcessMaterialInput::SceneColor];
		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Reset();
		Desc.ClearValue = FClearValueBinding(FLinearColor::Black);
		FRDGTextureRef Doubled = GraphBuilder.CreateTexture(Desc, TEXT("Doubled"));
		FRDGTextureRef Raised = GraphBuilder.CreateTexture(Desc, TEXT("Raised"));
		FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("TwoTargetsOutput"));
		AddTargetsPass<FTwoTargetsPS>(GraphBuilder, View, SceneColor.ViewRect,
			[&](auto* Parameters)
			{
				Parameters->Source = SceneColor.Texture;
				Parameters->RenderTargets[0] = FRenderTargetBinding(Doubled, ERenderTargetLoadAction::ENoAction);
				Parameters->RenderTargets[1] = FRenderTargetBinding(Raised, ERenderTargetLoadAction::EClear);
			});
		AddTargetsPass<FSubtractPS>(GraphBuilder, View, SceneColor.ViewRect,
			[&](auto* Parameters)
			{
				Parameters->Minuend = Raised;
				Parameters->Subtrahend = Doubled;
				Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
			});
		return FScreenPassTexture(Output, SceneColor.ViewRect);
	}
};

class FTwoTargetsModule : public FDefaultModuleImpl
{
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FTwoTargetsExtension>(); }
	TSharedPtr<FTwoTargetsExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FTwoTargetsModule, TwoTargets);
