#include "Interfaces/IPluginManager.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "ShaderCore.h"

#include "MyPatchViewExtension.h"

class FMyPatchModule final : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		const FString PluginFolder = IPluginManager::Get().FindPlugin(TEXT("MyPatch"))->GetBaseDir();
		AddShaderSourceDirectoryMapping(TEXT("/Plugin/MyPatch"), FPaths::Combine(PluginFolder, TEXT("Shaders")));

		// Shaders want the module early (LoadingPhase PostConfigInit), extensions want the engine.
		FCoreDelegates::OnPostEngineInit.AddRaw(this, &FMyPatchModule::OnPostEngineInit);
	}

	virtual void ShutdownModule() override
	{
		FCoreDelegates::OnPostEngineInit.RemoveAll(this);
		ViewExtension.Reset();
	}

private:
	void OnPostEngineInit() { ViewExtension = FSceneViewExtensions::NewExtension<FMyPatchViewExtension>(); }

	TSharedPtr<FMyPatchViewExtension, ESPMode::ThreadSafe> ViewExtension;
};

IMPLEMENT_MODULE(FMyPatchModule, MyPatch)
