// A component with a place. Source: engine file Components/SceneComponent.h.
#pragma once

#include "Components/ActorComponent.h"

/** The ways a component may move. Nothing moves by itself here. */
namespace EComponentMobility
{
enum Type : int
{
	Static,
	Stationary,
	Movable
};
} // namespace EComponentMobility

class DRYDOCK_API USceneComponent : public UActorComponent
{
public:
	DRYDOCK_CLASS(USceneComponent, UActorComponent)
	using UActorComponent::UActorComponent;

	/** In cm and degrees, in the world: there is no hierarchy of places. */
	FVector GetComponentLocation() const { return Location; }
	FRotator GetComponentRotation() const { return Rotation; }
	FVector GetComponentScale() const { return Scale; }
	void SetWorldLocation(const FVector& InLocation) { Location = InLocation; }
	void SetWorldRotation(const FRotator& InRotation) { Rotation = InRotation; }
	void SetWorldScale3D(const FVector& InScale) { Scale = InScale; }
	void SetMobility(EComponentMobility::Type InMobility) { Mobility = InMobility; }
	EComponentMobility::Type Mobility = EComponentMobility::Static;
	void SetupAttachment(USceneComponent* InParent, FName = NAME_None) { Parent = InParent; }
	USceneComponent* GetAttachParent() const { return Parent; }

private:
	FVector Location = FVector(0.0, 0.0, 0.0);
	FRotator Rotation = FRotator(0.0, 0.0, 0.0);
	FVector Scale = FVector(1.0, 1.0, 1.0);
	USceneComponent* Parent = nullptr;
};
