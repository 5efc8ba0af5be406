// A component with a place. Source: engine file Components/SceneComponent.h.
#pragma once

#include "Components/ActorComponent.h"

/** The place that an attached part keeps. Here it keeps its place in the world in any case. */
enum class EAttachmentRule : uint8
{
	KeepRelative,
	KeepWorld,
	SnapToTarget
};
namespace EAttachLocation
{
enum Type : int
{
	KeepRelativeOffset,
	KeepWorldPosition,
	SnapToTarget,
	SnapToTargetIncludingScale
};
} // namespace EAttachLocation
struct DRYDOCK_API FAttachmentTransformRules
{
	FAttachmentTransformRules(EAttachmentRule InRule, bool bInWeldSimulatedBodies)
		: LocationRule(InRule)
		, RotationRule(InRule)
		, ScaleRule(InRule)
		, bWeldSimulatedBodies(bInWeldSimulatedBodies)
	{
	}

	static const FAttachmentTransformRules KeepRelativeTransform;
	static const FAttachmentTransformRules KeepWorldTransform;
	static const FAttachmentTransformRules SnapToTargetNotIncludingScale;
	static const FAttachmentTransformRules SnapToTargetIncludingScale;

	EAttachmentRule LocationRule;
	EAttachmentRule RotationRule;
	EAttachmentRule ScaleRule;
	bool bWeldSimulatedBodies;
};

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
	FTransform GetComponentTransform() const { return FTransform(Rotation, Location, Scale); }
	void SetWorldTransform(const FTransform& Transform)
	{
		Location = Transform.GetLocation();
		Rotation = Transform.GetRotation().Rotator();
		Scale = Transform.GetScale3D();
	}
	void SetWorldLocation(const FVector& InLocation) { Location = InLocation; }
	void SetWorldRotation(const FRotator& InRotation) { Rotation = InRotation; }
	void SetWorldScale3D(const FVector& InScale) { Scale = InScale; }
	void SetMobility(EComponentMobility::Type InMobility) { Mobility = InMobility; }
	EComponentMobility::Type Mobility = EComponentMobility::Static;
	void SetupAttachment(USceneComponent* InParent, FName = NAME_None) { Parent = InParent; }
	bool AttachToComponent(USceneComponent* InParent, const FAttachmentTransformRules&, FName = NAME_None)
	{
		Parent = InParent;
		return Parent != nullptr;
	}
	/** The spelling of old engines. */
	bool AttachTo(USceneComponent* InParent, FName = NAME_None,
		EAttachLocation::Type = EAttachLocation::KeepRelativeOffset, bool = false)
	{
		Parent = InParent;
		return Parent != nullptr;
	}
	USceneComponent* GetAttachParent() const { return Parent; }
	FVector GetForwardVector() const { return Rotation.GetForward(); }
	FVector GetRightVector() const { return Rotation.GetRight(); }
	FVector GetUpVector() const { return Rotation.GetUp(); }

private:
	FVector Location = FVector(0.0, 0.0, 0.0);
	FRotator Rotation = FRotator(0.0, 0.0, 0.0);
	FVector Scale = FVector(1.0, 1.0, 1.0);
	USceneComponent* Parent = nullptr;
};
