// Source: engine World.cpp.
#include "PostProcessVolumeWeight.h"

#include <algorithm>
#include <cmath>

Drydock::FVolumeInfluence Drydock::GetInfluence(const FPostProcessVolumeProperties& Volume, double Distance)
{
	if (!Volume.bIsEnabled)
	{
		return {0.0f, EVolumeSkip::Disabled};
	}
	if (std::isnan(Volume.BlendWeight) ||
		(!Volume.bIsUnbound && (std::isnan(Distance) || std::isnan(Volume.BlendRadius))))
	{
		return {0.0f, EVolumeSkip::NotANumber};
	}
	const double Full = std::clamp(static_cast<double>(Volume.BlendWeight), 0.0, 1.0);
	if (Full == 0.0)
	{
		return {0.0f, EVolumeSkip::NoWeight};
	}
	if (Volume.bIsUnbound)
	{
		return {static_cast<float>(Full), EVolumeSkip::None};
	}
	const double Radius = static_cast<double>(Volume.BlendRadius);
	if (Distance > Radius)
	{
		return {0.0f, EVolumeSkip::OutOfRadius};
	}
	const float Weight = static_cast<float>(Radius >= 1.0 ? Full * (1.0 - Distance / Radius) : Full);
	return {Weight, Weight > 0.0f ? EVolumeSkip::None : EVolumeSkip::OutOfRadius};
}
