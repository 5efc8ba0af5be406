// Keeps the registered plugins.
#include "Interfaces/IPluginManager.h"

#include "RunningCode.h"

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
	const Drydock::FCodeOwner* const Running = Drydock::GetRunningCode();
	Plugins.Add(MakeShared<IPlugin>(Name, BaseDir, FString(Running != nullptr ? Running->Plugin : std::string())));
}

TSharedPtr<IPlugin> IPluginManager::FindRunningPlugin() const
{
	const Drydock::FCodeOwner* const Running = Drydock::GetRunningCode();
	if (Running != nullptr && Running->IsForeign())
	{
		const FString Library(Running->Plugin);
		const TSharedRef<IPlugin>* const Found = Plugins.FindByPredicate(
			[&Library](const TSharedRef<IPlugin>& Plugin) { return Plugin->GetLibrary() == Library; });
		if (Found != nullptr)
		{
			return TSharedPtr<IPlugin>(*Found);
		}
	}
	return Plugins.IsEmpty() ? nullptr : TSharedPtr<IPlugin>(Plugins.Last());
}
