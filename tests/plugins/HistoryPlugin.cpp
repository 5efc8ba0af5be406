// A plugin with a history of its own, where nobody sees it: it counts the frames that it has seen, and the picture
// shows the number. SequenceProgramTest.cpp runs a sequence with it.
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessing.h"

class FHistoryPluginExtension final : public FSceneViewExtensionBase
{
public:
	FHistoryPluginExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	void SetupViewFamily(FSceneViewFamily& InViewFamily) override { ++NumFrames; }
	void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override
	{
		InView.FinalPostProcessSettings.VignetteIntensity = 0.25f * static_cast<float>(NumFrames);
	}
	void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}

private:
	int32 NumFrames = 0;
};

class FHistoryPluginModule : public IModuleInterface
{
public:
	void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FHistoryPluginExtension>(); }
	void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FHistoryPluginExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FHistoryPluginModule, HistoryPlugin)
