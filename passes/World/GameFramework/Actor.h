// Actors: what code spawns into the empty world. Source: engine file GameFramework/Actor.h.
#pragma once

#include "Components/SceneComponent.h"
#include "Engine/TimerHandle.h"
#include "Engine/World.h"
#include "RunningCode.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API AActor : public UObject
{
public:
	DRYDOCK_CLASS(AActor, UObject)
	using UObject::UObject;

	FActorTickFunction PrimaryActorTick;
	TObjectPtr<USceneComponent> RootComponent;

	UWorld* GetWorld() const override;

	virtual void BeginPlay() {}
	virtual void EndPlay(const EEndPlayReason::Type) {}
	/** Called by Destroy, after EndPlay. */
	virtual void Destroyed() {}
	virtual void OnConstruction(const FTransform&) {}
	virtual void PostInitializeComponents() {}
	virtual void PostRegisterAllComponents() {}
	/** Called once before a frame, if PrimaryActorTick allows it; with the seconds since the frame before (of its own
	 * last tick where it has a TickInterval), times CustomTimeDilation. */
	virtual void Tick(float) {}
	virtual bool ShouldTickIfViewportsOnly() const { return false; }

	/** This actor's time goes so much faster than the world's. */
	float CustomTimeDilation = 1.0f;

	/** A flag that code may read: nothing of an actor is drawn here, hidden or not. */
	bool IsHidden() const { return bHidden; }
	virtual void SetActorHiddenInGame(bool bNewHidden) { bHidden = bNewHidden; }
	/** Its own and the world's, multiplied. */
	float GetActorTimeDilation() const;

	USceneComponent* GetRootComponent() const { return RootComponent.Get(); }
	void SetRootComponent(USceneComponent* InRootComponent) { RootComponent = InRootComponent; }
	FVector GetActorLocation() const
	{
		return RootComponent ? RootComponent->GetComponentLocation() : FVector(0.0, 0.0, 0.0);
	}
	/** False without a root component. */
	bool SetActorLocationAndRotation(const FVector& Location, const FRotator& Rotation)
	{
		if (RootComponent)
		{
			RootComponent->SetWorldLocation(Location);
			RootComponent->SetWorldRotation(Rotation);
		}
		return RootComponent.Get() != nullptr;
	}
	bool SetActorLocation(const FVector& Location) { return SetActorLocationAndRotation(Location, GetActorRotation()); }
	bool SetActorRotation(const FRotator& Rotation)
	{
		return SetActorLocationAndRotation(GetActorLocation(), Rotation);
	}
	/** The root component's. */
	FTransform GetActorTransform() const
	{
		return RootComponent ? RootComponent->GetComponentTransform() : FTransform();
	}
	FRotator GetActorRotation() const
	{
		return RootComponent ? RootComponent->GetComponentRotation() : FRotator(0.0, 0.0, 0.0);
	}
	/** Turned about its own axes, and moved along them. False without a root component. */
	bool AddActorLocalRotation(const FRotator& Delta)
	{
		return SetActorRotation((GetActorRotation().Quaternion() * Delta.Quaternion()).Rotator());
	}
	bool AddActorLocalTransform(const FTransform& Delta)
	{
		return SetActorLocationAndRotation(GetActorLocation() + GetActorRotation().RotateVector(Delta.GetLocation()),
			(GetActorRotation().Quaternion() * Delta.GetRotation()).Rotator());
	}
	bool AttachToActor(AActor* Parent, const FAttachmentTransformRules& Rules, FName Socket = NAME_None)
	{
		return RootComponent && RootComponent->AttachToComponent(Parent->GetRootComponent(), Rules, Socket);
	}
	bool AttachToComponent(USceneComponent* Parent, const FAttachmentTransformRules& Rules, FName Socket = NAME_None)
	{
		return RootComponent && RootComponent->AttachToComponent(Parent, Rules, Socket);
	}
	/** Words that code marks it with. */
	TArray<FName> Tags;
	bool ActorHasTag(FName Tag) const { return Tags.Contains(Tag); }
	FVector GetActorForwardVector() const { return GetActorRotation().Vector(); }
	FVector GetActorRightVector() const { return GetActorRotation().GetRight(); }
	FVector GetActorUpVector() const { return GetActorRotation().GetUp(); }
	/** The world's. */
	FTimerManager& GetWorldTimerManager() const;
	void SetActorTickEnabled(bool bEnabled) { PrimaryActorTick.SetTickFunctionEnable(bEnabled); }

	/** A part of this actor; a component begins to play with it. */
	template<typename T>
	T* CreateDefaultSubobject(FName SubobjectName, bool = false)
	{
		T* const Part = UObject::CreateDefaultSubobject<T>(SubobjectName);
		if constexpr (std::is_base_of_v<UActorComponent, T>)
		{
			Components.Add(static_cast<UActorComponent*>(Part));
		}
		return Part;
	}
	/** The first component that is a T, or null. */
	template<typename T>
	T* FindComponentByClass() const
	{
		for (const TWeakObjectPtr<UActorComponent>& Component : Components)
		{
			if (T* const Found = Cast<T>(Component.Get()))
			{
				return Found;
			}
		}
		return nullptr;
	}

	/** Ends its play and takes it out of the world; the object is gone. An actor of a plugin must not outlive it: its
	 * module destroys it in ShutdownModule. */
	void Destroy();

	/** Ours: UWorld::PlaceActor, for code that knows no worlds. */
	template<typename T>
	static void PlaceInWorld()
	{
		GWorld->PlaceActor<T>();
	}

	/** Ours: registers the components, then they and the actor begin to play. UWorld::SpawnActor calls it. */
	void StartPlay();

	/** Ours: ticks what is in that group of it and its components. */
	void TickGroup(ETickingGroup Group, float DeltaSeconds);
	/** Ours: a component that was made for it and registered. */
	void AddOwnedComponent(UActorComponent* Component);
	/** Ours: those that live. */
	std::vector<UActorComponent*> GetOwnedComponents() const;

private:
	TArray<TWeakObjectPtr<UActorComponent>> Components;
	Drydock::FCodeOwner Owner;
	bool bHidden = false;
	bool bPlays = false;
};

inline AActor* UActorComponent::GetOwner() const
{
	return Cast<AActor>(GetOuter());
}
