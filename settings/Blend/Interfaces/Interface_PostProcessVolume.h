// Declares the interface of objects that take part in a blend as a post-process volume. Source: engine
// Interfaces/Interface_PostProcessVolume.h.
#pragma once

#include "PostProcessSettings.h"

/** The properties of a volume that blending needs. */
struct FPostProcessVolumeProperties
{
	const FPostProcessSettings* Settings = nullptr; // the volume's
	float Priority = 0.0f;
	float BlendRadius = 0.0f; // cm
	float BlendWeight = 0.0f;
	bool bIsEnabled = false;
	bool bIsUnbound = false;
};

class IInterface_PostProcessVolume
{
public:
	virtual ~IInterface_PostProcessVolume() = default;

	/** Whether a sphere around Point touches the volume, bounded or not; the distance to the volume is 0 inside. */
	virtual bool EncompassesPoint(
		FVector Point, float SphereRadius = 0.0f, float* OutDistanceToPoint = nullptr) const = 0;
	virtual FPostProcessVolumeProperties GetProperties() const = 0;
	virtual FString GetDebugName() const = 0;
};
