// Project settings: read with GetDefault<T>(). No ini file is read; the values are those of the constructor. Source:
// engine file Engine/DeveloperSettings.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API UDeveloperSettings : public UObject
{
public:
	using Super = UDeveloperSettings;
	using UObject::UObject;

	FName CategoryName;
	FName SectionName;

	virtual FName GetContainerName() const { return FName(TEXT("Project")); }
	virtual FName GetCategoryName() const { return CategoryName; }
	virtual FName GetSectionName() const { return SectionName; }
	/** Nothing is written. */
	void SaveConfig() {}
	void LoadConfig() {}
};
