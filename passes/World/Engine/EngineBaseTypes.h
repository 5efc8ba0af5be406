// Small enumerations and the tick function. Source: engine files Engine/EngineBaseTypes.h, Engine/EngineTypes.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

namespace EWorldType
{
enum Type
{
	None,
	Game,
	Editor,
	PIE,
	EditorPreview,
	GamePreview,
	GameRPC,
	Inactive
};
} // namespace EWorldType

namespace EEndPlayReason
{
enum Type : int
{
	Destroyed,
	LevelTransition,
	EndPlayInEditor,
	RemovedFromWorld,
	Quit
};
} // namespace EEndPlayReason

enum ELevelTick : int
{
	LEVELTICK_TimeOnly = 0,
	LEVELTICK_ViewportsOnly = 1,
	LEVELTICK_All = 2,
	LEVELTICK_PauseTick = 3
};

enum ETickingGroup : int
{
	TG_PrePhysics,
	TG_StartPhysics,
	TG_DuringPhysics,
	TG_EndPhysics,
	TG_PostPhysics,
	TG_PostUpdateWork,
	TG_LastDemotable,
	TG_NewlySpawned,
	TG_MAX
};

/** The tick options of an actor or component. */
struct FTickFunction
{
	ETickingGroup TickGroup = TG_PrePhysics;
	bool bCanEverTick = false;
	bool bStartWithTickEnabled = true;
	bool bTickEvenWhenPaused = false;
	float TickInterval = 0.0f; // s

	void SetTickFunctionEnable(bool bEnabled) { bTickEnabled = bEnabled; }
	bool IsTickFunctionEnabled() const { return bTickEnabled; }

	/** Ours: a frame of so many seconds comes. Whether it ticks, and with how many. */
	DRYDOCK_API bool Advance(float DeltaSeconds, float& OutSeconds);

private:
	float Waited = 0.0f; // s since its last tick
	bool bTickEnabled = false;
};

struct FActorTickFunction : public FTickFunction
{
};

struct FActorComponentTickFunction : public FTickFunction
{
};
