// Objects of plugins, besides actors, that tick once a frame. Source: engine file Tickable.h.
#pragma once

#include "CoreMinimal.h"
#include "RunningCode.h"
#include "Stats/Stats.h"

enum class ETickableTickType : uint8
{
	Conditional, // while IsTickable is true
	Always,
	Never,
	NewObject,
};

/** Ticks from its construction on, after the actors and timers of a frame. A class's default object does not tick. */
class DRYDOCK_API FTickableGameObject
{
public:
	FTickableGameObject();
	virtual ~FTickableGameObject();
	FTickableGameObject(const FTickableGameObject&) = delete;
	FTickableGameObject& operator=(const FTickableGameObject&) = delete;

	/** In seconds: those of the sequence since the frame before. */
	virtual void Tick(float DeltaTime) = 0;
	virtual TStatId GetStatId() const = 0;
	virtual bool IsTickable() const { return true; }
	virtual ETickableTickType GetTickableTickType() const { return ETickableTickType::Conditional; }
	virtual bool IsTickableWhenPaused() const { return false; }
	virtual bool IsTickableInEditor() const { return false; }
	virtual UWorld* GetTickableGameObjectWorld() const { return nullptr; }

	/** Ours: ticks all, in the order of their construction. */
	static void TickAll(float DeltaSeconds);

private:
	Drydock::FCodeOwner Owner;
};
