// Keeps the registered plugins.
#include "Interfaces/IPluginManager.h"

IPluginManager& IPluginManager::Get()
{
	static IPluginManager Manager;
	return Manager;
}

TSharedPtr<IPlugin> IPluginManager::FindPlugin(const FString& Name) const
{
	const TSharedRef<IPlugin>* Found =
		Plugins.FindByPredicate([&Name](const TSharedRef<IPlugin>& Plugin) { return Plugin->GetName() == Name; });
	return Found != nullptr ? TSharedPtr<IPlugin>(*Found) : nullptr;
}

TArray<TSharedRef<IPlugin>> IPluginManager::GetEnabledPlugins() const
{
	return Plugins;
}

void IPluginManager::RegisterPlugin(const FString& Name, const FString& BaseDir)
{
	// Loaded again from another place: that is where it is now.
	Plugins.RemoveAll([&Name](const TSharedRef<IPlugin>& Plugin) { return Plugin->GetName() == Name; });
	Plugins.Add(MakeShared<IPlugin>(Name, BaseDir));
}
