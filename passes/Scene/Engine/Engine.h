// GEngine: what code from outside reaches through it. Source: engine file Engine/Engine.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/World.h"
#include "Subsystems/EngineSubsystem.h"
#include "UObject/Object.h"

class FSceneViewExtensions;

class DRYDOCK_API UEngine : public UObject
{
public:
	UEngine();
	~UEngine() override;

	/** Always valid. */
	TSharedPtr<FSceneViewExtensions> ViewExtensions;

	/** Null if no plugin brings it. */
	template<typename T>
	T* GetEngineSubsystem() const
	{
		return Drydock::FSubsystems::Get().Find<T>(Drydock::ESubsystemKind::Engine);
	}
	UWorld* GetCurrentPlayWorld(UWorld* = nullptr) const { return GWorld; }
};

/** Valid from the moment the library is loaded. */
extern DRYDOCK_API UEngine* GEngine;
