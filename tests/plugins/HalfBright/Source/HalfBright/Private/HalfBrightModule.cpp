// Maps its shaders by hand, and makes its extension once the engine stands.
#include "HalfBrightModule.h"

#include "HalfBrightExtension.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "ShaderCore.h"

void FHalfBrightModule::StartupModule()
{
	const FString BaseDir = IPluginManager::Get().FindPlugin(TEXT("HalfBright"))->GetBaseDir();
	AddShaderSourceDirectoryMapping(
		TEXT("/HalfBrightShaders"), FPaths::Combine(BaseDir, TEXT("Shaders"), TEXT("Private")));
	PostEngineInitHandle = FCoreDelegates::OnPostEngineInit.AddRaw(this, &FHalfBrightModule::OnPostEngineInit);
}

void FHalfBrightModule::OnPostEngineInit()
{
	Extension = FSceneViewExtensions::NewExtension<FHalfBrightExtension>(0.5f);
}

void FHalfBrightModule::ShutdownModule()
{
	FCoreDelegates::OnPostEngineInit.Remove(PostEngineInitHandle);
	Extension.Reset();
}

IMPLEMENT_MODULE(FHalfBrightModule, HalfBright)
