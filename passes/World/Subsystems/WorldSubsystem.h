// Subsystems of the world: made once, since there is one world. Source: engine file Subsystems/WorldSubsystem.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/World.h"
#include "Subsystems/Subsystem.h"
#include "Tickable.h"
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
	/** Ours: the world has started it. */
	bool IsStarted() const { return bStarted; }

protected:
	/** The world is EWorldType::Game. */
	virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const;

private:
	bool bStarted = false;
};

/** Ticks once a frame from its start on. */
class DRYDOCK_API UTickableWorldSubsystem : public UWorldSubsystem, public FTickableGameObject
{
public:
	DRYDOCK_CLASS(UTickableWorldSubsystem, UWorldSubsystem)
	using UWorldSubsystem::UWorldSubsystem;

	void Tick(float) override {}
	TStatId GetStatId() const override { return TStatId(); }
	ETickableTickType GetTickableTickType() const override
	{
		return IsStarted() ? ETickableTickType::Conditional : ETickableTickType::Never;
	}
};
