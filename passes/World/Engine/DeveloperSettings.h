// Project settings: read with GetDefault<T>(). Values are those of the constructor, of the plugin's Config/Default*.ini
// and of a config's "objects" (docs/plugins.md). Source: engine file Engine/DeveloperSettings.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API UDeveloperSettings : public UObject
{
public:
	DRYDOCK_CLASS(UDeveloperSettings, UObject)
	using UObject::UObject;

	FName CategoryName;
	FName SectionName;

	virtual FName GetContainerName() const { return FName(TEXT("Project")); }
	virtual FName GetCategoryName() const { return CategoryName; }
	virtual FName GetSectionName() const { return SectionName; }
	/** Nothing is written, and ini files are read once, when the plugin is loaded. */
	void SaveConfig() {}
	void LoadConfig() {}
	bool TryUpdateDefaultConfigFile(const FString& = FString(), bool = true) { return false; }
};

/** In the engine console variables and fields follow each other (meta ConsoleVariable); here the fields are as those of
 * any settings, and move no variable. */
class DRYDOCK_API UDeveloperSettingsBackedByCVars : public UDeveloperSettings
{
public:
	DRYDOCK_CLASS(UDeveloperSettingsBackedByCVars, UDeveloperSettings)
	using UDeveloperSettings::UDeveloperSettings;
};
