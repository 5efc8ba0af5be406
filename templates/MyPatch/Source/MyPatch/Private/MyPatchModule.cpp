#include "Interfaces/IPluginManager.h"
#include "Misc/CoreDelegates.h"
#include "Misc/EngineVersionComparison.h"
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
		GetPostEngineInit().AddRaw(this, &FMyPatchModule::OnPostEngineInit);
	}

	virtual void ShutdownModule() override
	{
		GetPostEngineInit().RemoveAll(this);
		ViewExtension.Reset();
	}

private:
	static FSimpleMulticastDelegate& GetPostEngineInit()
	{
#if UE_VERSION_OLDER_THAN(5, 8, 0)
		return FCoreDelegates::OnPostEngineInit;
#else
		return FCoreDelegates::GetOnPostEngineInit();
#endif
	}
	void OnPostEngineInit()
	{
		ViewExtension = FSceneViewExtensions::NewExtension<FMyPatchViewExtension>();
	}

	TSharedPtr<FMyPatchViewExtension, ESPMode::ThreadSafe> ViewExtension;
};

IMPLEMENT_MODULE(FMyPatchModule, MyPatch)
