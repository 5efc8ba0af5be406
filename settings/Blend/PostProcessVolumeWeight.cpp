// A volume's weight by distance, and the reasons why one is skipped, in words. Source: engine World.cpp for the weight.
#include "PostProcessVolumeWeight.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Drydock
{

namespace
{

/** Centimetres, to a tenth where that is of interest. */
std::string LengthText(double Length)
{
	constexpr double Readable = 1e9;
	char Buffer[64];
	std::snprintf(Buffer, sizeof(Buffer), std::fabs(Length) < Readable ? "%.1f" : "%.4g", Length);
	return Buffer;
}

} // namespace

std::string ExplainSkip(EVolumeSkip Skip, const FPostProcessVolumeProperties& Volume, double Distance)
{
	switch (Skip)
	{
	case EVolumeSkip::None:
		return "";
	case EVolumeSkip::Disabled:
		return "disabled";
	case EVolumeSkip::NoWeight:
		return "BlendWeight is 0";
	case EVolumeSkip::NotANumber:
		return "its weight is not a number";
	case EVolumeSkip::OutOfRadius:
		break;
	}
	return "out of radius: " + LengthText(Distance) + " cm away, BlendRadius " +
		   LengthText(static_cast<double>(Volume.BlendRadius));
}

FVolumeInfluence GetInfluence(const FPostProcessVolumeProperties& Volume, double Distance)
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
	return Weight > 0.0f ? FVolumeInfluence{Weight, EVolumeSkip::None}
						 : FVolumeInfluence{0.0f, EVolumeSkip::OutOfRadius};
}

} // namespace Drydock
