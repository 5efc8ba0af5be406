// Components of actors. Nobody places them here: they live when code makes them (CreateDefaultSubobject in an actor
// that UWorld::SpawnActor makes, or NewObject and RegisterComponent). Source: engine files Components/ActorComponent.h,
// Components/SceneComponent.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "UObject/ScriptDelegates.h"

class AActor;

class DRYDOCK_API UActorComponent : public UObject
{
public:
	DRYDOCK_CLASS(UActorComponent, UObject)
	using UObject::UObject;

	FActorComponentTickFunction PrimaryComponentTick;
	bool bWantsInitializeComponent = false;
	bool bAutoActivate = false;

	UWorld* GetWorld() const override;
	/** The actor it is a part of, or null. */
	AActor* GetOwner() const;

	virtual void OnRegister() {}
	virtual void OnUnregister() {}
	virtual void InitializeComponent() {}
	virtual void UninitializeComponent() {}
	virtual void BeginPlay() {}
	virtual void EndPlay(const EEndPlayReason::Type) {}
	/** Called once before a frame, behind the actor's Tick, if PrimaryComponentTick allows it; with the actor's
	 * seconds. */
	virtual void TickComponent(float, ELevelTick, FActorComponentTickFunction*) {}
	virtual void Activate(bool = false) { bActive = true; }
	virtual void Deactivate() { bActive = false; }
	bool IsActive() const { return bActive; }

	void RegisterComponent();
	void UnregisterComponent();
	bool IsRegistered() const { return bRegistered; }
	void SetComponentTickEnabled(bool bEnabled) { PrimaryComponentTick.SetTickFunctionEnable(bEnabled); }
	void MarkRenderStateDirty() {}

	/** Ours: begins to play, once. */
	void StartPlay();

private:
	bool bRegistered = false;
	bool bActive = false;
	bool bPlays = false;
};
