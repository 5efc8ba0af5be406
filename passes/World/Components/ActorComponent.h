// Components of actors. They live when code makes them (CreateDefaultSubobject in an actor that UWorld::SpawnActor
// makes, or NewObject and RegisterComponent), or when a config's "objects" names their class. Source: engine files
// Components/ActorComponent.h, Components/SceneComponent.h.
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
	/** Called if bWantsInitializeComponent is set. */
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

	/** Activates it, too, if bAutoActivate is set. */
	void RegisterComponent();
	void UnregisterComponent();
	bool IsRegistered() const { return bRegistered; }
	void SetComponentTickEnabled(bool bEnabled) { PrimaryComponentTick.SetTickFunctionEnable(bEnabled); }
	void MarkRenderStateDirty() {}

	/** Ours: begins to play, once. */
	void StartPlay();

	/** Ours: an actor with such a component, as somebody adds it in a level, unless an actor of the world has one. */
	template<typename T>
	static void PlaceInWorld()
	{
		Place([](const UActorComponent* Component) { return dynamic_cast<const T*>(Component) != nullptr; },
			[](AActor* Actor) -> UActorComponent* { return NewObject<T>(ToObject(Actor)); });
	}

private:
	static UObject* ToObject(AActor* Actor);
	static void Place(bool (*IsOne)(const UActorComponent*), UActorComponent* (*Make)(AActor*));

	bool bRegistered = false;
	bool bActive = false;
	bool bPlays = false;
};
