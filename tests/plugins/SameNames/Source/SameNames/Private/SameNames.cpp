// The article's extension by its own name: with a layout of its own, a shader class of its own and everything else that
// bears a name of drydock's. Draws half of the picture plus one where all of these are the plugin's.
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "Modules/ModuleManager.h"
#include "OwnNames.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "SceneRendering.h"
#include "SceneViewExtension.h"
#include "ShaderParameterStruct.h"

/** A plugin stays loaded: other tests of the process are not to see it. */
static TAutoConsoleVariable<int32> CVarSameNames(TEXT("r.SameNames"), 0, TEXT("1: draws."));

class FDualKawaseBlurPS final : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDualKawaseBlurPS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseBlurPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER(float, OwnShare)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FDualKawaseBlurPS, "/Plugin/SameNames/SameNames.usf", "MainPS", SF_Pixel);

class FDualKawaseBlur : public FSceneViewExtensionBase
{
public:
	FDualKawaseBlur(const FAutoRegister& AutoRegister, float InOffset, int32 InPassNum, bool bInUseGaussian);
	virtual ~FDualKawaseBlur();

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override;

private:
	FScreenPassTexture AddPasses(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs);

	TArray<FString> Layout; // drydock's has none of this
	double More[32] = {};
};

FDualKawaseBlur::FDualKawaseBlur(
	const FAutoRegister& AutoRegister, float InOffset, int32 InPassNum, bool bInUseGaussian)
	: FSceneViewExtensionBase(AutoRegister)
{
	Layout.Add(TEXT("Own"));
	More[31] = InOffset;
}

FDualKawaseBlur::~FDualKawaseBlur() = default;

void FDualKawaseBlur::SubscribeToPostProcessingPass(
	EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
{
	if (PassId == EPostProcessingPass::MotionBlur && CVarSameNames.GetValueOnAnyThread() != 0)
	{
		InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FDualKawaseBlur::AddPasses));
	}
}

FScreenPassTexture FDualKawaseBlur::AddPasses(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));

	int32 NumOwn = Layout.Num();
	int32 NumAll = 1;
#define SAME_NAMES_ASK_CLASS(Name) NumOwn += TUniquePtr<Name>(new Name)->GetOwn(), ++NumAll;
#define SAME_NAMES_ASK_PASS(Name, PassInputs) NumOwn += Name(GraphBuilder, ViewInfo, PassInputs()), ++NumAll;
#define SAME_NAMES_ASK_QUESTION(Name) NumOwn += Name(), ++NumAll;
	SAME_NAMES_ALL_CLASSES(SAME_NAMES_ASK_CLASS)
	SAME_NAMES_ALL_PASSES(SAME_NAMES_ASK_PASS)
	SAME_NAMES_ALL_QUESTIONS(SAME_NAMES_ASK_QUESTION)

	FRDGTextureDesc Desc = SceneColor.Texture->Desc;
	Desc.Reset();
	Desc.Flags |= TexCreate_RenderTargetable;
	FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("SameNames"));

	FDualKawaseBlurPS::FParameters* Parameters = GraphBuilder.AllocParameters<FDualKawaseBlurPS::FParameters>();
	Parameters->InputTexture = SceneColor.Texture;
	Parameters->OwnShare = static_cast<float>(NumOwn) / static_cast<float>(NumAll);
	Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
	TShaderMapRef<FDualKawaseBlurPS> PixelShader(ViewInfo.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, ViewInfo.ShaderMap, RDG_EVENT_NAME("SameNames"), PixelShader, Parameters, SceneColor.ViewRect);
	return FScreenPassTexture(Output, SceneColor.ViewRect);
}

class FSameNamesModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.0f, 3, false);
	}
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FDualKawaseBlur, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FSameNamesModule, SameNames)
