// Finds the folders of plugins, so that they can map their shaders. Source: engine Interfaces/IPluginManager.h.
#pragma once

#include "Containers/UnrealString.h"
#include "Templates/SharedPointer.h"

class DRYDOCK_API IPlugin
{
public:
	IPlugin(FString InName, FString InBaseDir, FString InLibrary = FString())
		: Name(std::move(InName))
		, BaseDir(std::move(InBaseDir))
		, Library(std::move(InLibrary))
	{
	}

	const FString& GetName() const { return Name; }
	/** The folder of the plugin's sources; shaders are in Shaders below it. */
	FString GetBaseDir() const { return BaseDir; }
	FString GetContentDir() const { return BaseDir / TEXT("Content"); }

	/** Ours: file name of the shared object; empty for one that is part of the program. */
	const FString& GetLibrary() const { return Library; }

private:
	FString Name;
	FString BaseDir;
	FString Library;
};

class DRYDOCK_API IPluginManager
{
public:
	static IPluginManager& Get();

	/** Null if no plugin of that name was registered. */
	TSharedPtr<IPlugin> FindPlugin(const FString& Name) const;
	TArray<TSharedRef<IPlugin>> GetEnabledPlugins() const;

	/** Ours: the plugin whose code runs on this thread; where none does, the one that was registered last. Null without
	 * plugins. */
	TSharedPtr<IPlugin> FindRunningPlugin() const;

	/** Ours: drydock_add_plugin makes every plugin call it when it is loaded. */
	void RegisterPlugin(const FString& Name, const FString& BaseDir);

private:
	IPluginManager() = default;

	TArray<TSharedRef<IPlugin>> Plugins;
};
