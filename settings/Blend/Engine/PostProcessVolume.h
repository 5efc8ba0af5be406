// A post-process volume: settings, and where and how strongly they act. Source: engine Engine/PostProcessVolume.h; the
// shape is drydock's.
#pragma once

#include "Interfaces/Interface_PostProcessVolume.h"
#include "PostProcessVolumeShape.h"

class DRYDOCK_API APostProcessVolume final : public IInterface_PostProcessVolume
{
public:
	FPostProcessSettings Settings;
	float Priority = 0.0f;      // higher is applied later and wins
	float BlendRadius = 100.0f; // cm around the shape over which the weight falls to 0; below 1: none, or all
	float BlendWeight = 1.0f;   // clamped to 0..1
	uint8 bEnabled : 1 = 1;
	uint8 bUnbound : 1 = 0;      // acts everywhere; the shape is not looked at
	Drydock::FVolumeShape Shape; // drydock
	FString Name;                // drydock: in the ledger

	bool EncompassesPoint(FVector Point, float SphereRadius = 0.0f, float* OutDistanceToPoint = nullptr) const override;
	FPostProcessVolumeProperties GetProperties() const override;
	FString GetDebugName() const override { return Name; }
};
