// Subsystems of the world: made once, since there is one world. Source: engine file Subsystems/WorldSubsystem.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/World.h"
#include "Subsystems/Subsystem.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API UWorldSubsystem : public USubsystem
{
public:
	DRYDOCK_CLASS(UWorldSubsystem, USubsystem)
	using USubsystem::USubsystem;

	static constexpr Drydock::ESubsystemKind SubsystemKind = Drydock::ESubsystemKind::World;

	/** True where DoesSupportWorldType is. */
	bool ShouldCreateSubsystem(UObject* Outer) const override;
	UWorld* GetWorld() const override;
	UWorld& GetWorldRef() const { return *GetWorld(); }
	/** Called after all of the world's subsystems have been initialised. */
	virtual void PostInitialize() {}
	virtual void OnWorldBeginPlay(UWorld&) {}

	void OnCollectionStarted() final;

protected:
	/** The world is EWorldType::Game. */
	virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const;
};

/** Nothing ticks here: a frame is one moment. */
class DRYDOCK_API UTickableWorldSubsystem : public UWorldSubsystem
{
public:
	DRYDOCK_CLASS(UTickableWorldSubsystem, UWorldSubsystem)
	using UWorldSubsystem::UWorldSubsystem;

	virtual void Tick(float) {}
	virtual TStatId GetStatId() const { return TStatId(); }
	virtual bool IsTickable() const { return true; }
};
