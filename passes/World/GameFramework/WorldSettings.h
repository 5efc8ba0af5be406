// Settings of the world: the engine's defaults, which code may change. Source: engine file
// GameFramework/WorldSettings.h.
#pragma once

#include "GameFramework/Actor.h"

class DRYDOCK_API AWorldSettings : public AActor
{
public:
	DRYDOCK_CLASS(AWorldSettings, AActor)
	using AActor::AActor;

	float WorldToMeters = 100.0f; // cm in a metre
	float TimeDilation = 1.0f;
	float KillZ = -1048575.0f; // cm
	bool bEnableWorldBoundsChecks = true;

	float GetEffectiveTimeDilation() const { return TimeDilation; }
};
