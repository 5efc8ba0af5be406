// An extension that uses everything of OwnNames.h. Draws half of the picture plus one where all of it is the plugin's.
#include "AskNames.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "SceneRendering.h"
#include "SceneViewExtension.h"
#include "ShaderParameterStruct.h"

/** A plugin stays loaded: other tests of the process are not to see it. */
static TAutoConsoleVariable<int32> CVarSameNames(TEXT("r.SameNames"), 0, TEXT("1: draws."));

class FSameNamesPS final : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FSameNamesPS);
	SHADER_USE_PARAMETER_STRUCT(FSameNamesPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER(float, OwnShare)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FSameNamesPS, "/Plugin/SameNames/SameNames.usf", "MainPS", SF_Pixel);

class FSameNames : public FSceneViewExtensionBase
{
public:
	FSameNames(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override;

private:
	FScreenPassTexture AddPasses(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs);
};

void FSameNames::SubscribeToPostProcessingPass(
	EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
{
	if (PassId == EPostProcessingPass::MotionBlur && CVarSameNames.GetValueOnAnyThread() != 0)
	{
		InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FSameNames::AddPasses));
	}
}

FScreenPassTexture FSameNames::AddPasses(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));

	FRDGTextureDesc Desc = SceneColor.Texture->Desc;
	Desc.Reset();
	Desc.Flags |= TexCreate_RenderTargetable;
	FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("SameNames"));

	FSameNamesPS::FParameters* Parameters = GraphBuilder.AllocParameters<FSameNamesPS::FParameters>();
	Parameters->InputTexture = SceneColor.Texture;
	Parameters->OwnShare = AskNames(GraphBuilder, ViewInfo);
	Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
	TShaderMapRef<FSameNamesPS> PixelShader(ViewInfo.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, ViewInfo.ShaderMap, RDG_EVENT_NAME("SameNames"), PixelShader, Parameters, SceneColor.ViewRect);
	return FScreenPassTexture(Output, SceneColor.ViewRect);
}

class FSameNamesModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FSameNames>(); }
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FSameNames, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FSameNamesModule, SameNames)
