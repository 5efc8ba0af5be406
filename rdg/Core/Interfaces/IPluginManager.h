// Where plugins are, so that they can map their shaders. Source: engine Interfaces/IPluginManager.h.
#pragma once

#include "Containers/UnrealString.h"
#include "Templates/SharedPointer.h"

class DRYDOCK_API IPlugin
{
public:
	IPlugin(FString InName, FString InBaseDir)
		: Name(std::move(InName))
		, BaseDir(std::move(InBaseDir))
	{
	}

	const FString& GetName() const { return Name; }
	/** The folder of the plugin's sources; shaders are in Shaders below it. */
	FString GetBaseDir() const { return BaseDir; }

private:
	FString Name;
	FString BaseDir;
};

class DRYDOCK_API IPluginManager
{
public:
	static IPluginManager& Get();

	/** Null if no plugin of that name was registered. */
	TSharedPtr<IPlugin> FindPlugin(const FString& Name) const;
	TArray<TSharedRef<IPlugin>> GetEnabledPlugins() const;

	/** Ours: drydock_add_plugin makes every plugin call it when it is loaded. */
	void RegisterPlugin(const FString& Name, const FString& BaseDir);

private:
	IPluginManager() = default;

	TArray<TSharedRef<IPlugin>> Plugins;
};
