// Maps the plugin's shaders to the article's virtual folder and makes the extension, with an offset and a number of
// passes that nothing of drydock's has by default.
#include "DualKawaseBlur.h"
#include "Interfaces/IPluginManager.h"
#include "Modules/ModuleManager.h"

class FArticleBlurModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		const FString Folder = IPluginManager::Get().FindPlugin(TEXT("ArticleBlur"))->GetBaseDir();
		AddShaderSourceDirectoryMapping(TEXT("/ProjectS"), FPaths::Combine(Folder, TEXT("Shaders")));
		DualKawaseBlur = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.5f, 2, false);
	}
	virtual void ShutdownModule() override { DualKawaseBlur.Reset(); }

private:
	TSharedPtr<FDualKawaseBlur, ESPMode::ThreadSafe> DualKawaseBlur;
};

IMPLEMENT_MODULE(FArticleBlurModule, ArticleBlur)
