// Source: engine World.cpp; the reasons are drydock's.
#include "PostProcessVolumeWeight.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace Drydock
{

namespace
{

/** Centimetres, to a tenth. */
std::string LengthText(double Length)
{
	char Buffer[64];
	return std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Length, std::chars_format::fixed, 1).ptr);
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
	return {Weight, Weight > 0.0f ? EVolumeSkip::None : EVolumeSkip::OutOfRadius};
}

} // namespace Drydock
