// A plugin as for Unreal: a module that makes a view extension, which turns the picture red after the tonemapper and
// sets the vignette while its console variable is on. ConfigPluginsTest.cpp loads it.
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessing.h"

static TAutoConsoleVariable<int32> CVarEnabled(
	TEXT("r.TestPlugin.Enabled"), 0, TEXT("1: the picture is red."), ECVF_RenderThreadSafe);

class FTestPluginExtension final : public FSceneViewExtensionBase
{
public:
	FTestPluginExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	void SetupViewFamily(FSceneViewFamily& InViewFamily) override{};
	void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override
	{
		if (CVarEnabled.GetValueOnGameThread() != 0)
		{
			InView.FinalPostProcessSettings.VignetteIntensity = 0.75f;
		}
	}
	void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override{};
	void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		if (PassId == EPostProcessingPass::Tonemap && bIsPassEnabled && CVarEnabled.GetValueOnRenderThread() != 0)
		{
			InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FTestPluginExtension::Redden));
		}
	}

private:
	FScreenPassTexture Redden(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		FScreenPassRenderTarget Output = Inputs.OverrideOutput;
		if (!Output.IsValid())
		{
			Output = FScreenPassRenderTarget::CreateFromInput(
				GraphBuilder, SceneColor, View.GetOverwriteLoadAction(), TEXT("Red"));
		}
		AddClearRenderTargetPass(GraphBuilder, Output.Texture, FLinearColor::Red);
		return MoveTemp(Output);
	}
};

class FTestPluginModule : public IModuleInterface
{
public:
	void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FTestPluginExtension>(); }
	void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FTestPluginExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FTestPluginModule, TestPlugin)
