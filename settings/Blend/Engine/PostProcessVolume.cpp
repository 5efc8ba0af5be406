// Gives the blend a volume's distance and properties. Source: engine PostProcessVolume.cpp.
#include "Engine/PostProcessVolume.h"

bool APostProcessVolume::EncompassesPoint(FVector Point, float SphereRadius, float* OutDistanceToPoint) const
{
	const double Distance = Shape.GetDistance(Point);
	if (OutDistanceToPoint != nullptr)
	{
		*OutDistanceToPoint = static_cast<float>(Distance);
	}
	return Distance <= static_cast<double>(SphereRadius);
}

FPostProcessVolumeProperties APostProcessVolume::GetProperties() const
{
	return {&Settings, Priority, BlendRadius, BlendWeight, bEnabled != 0, bUnbound != 0};
}
