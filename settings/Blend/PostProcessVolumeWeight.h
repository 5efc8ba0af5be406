// Computes a volume's weight at a distance, or the reason why it has none. Source: engine World.cpp; the reasons are
// drydock's.
#pragma once

#include "Interfaces/Interface_PostProcessVolume.h"

#include <string>

namespace Drydock
{

/** Why a volume does nothing at a point. */
enum class EVolumeSkip : uint8
{
	None,
	Disabled,
	NoWeight,    // BlendWeight is 0 or less
	NotANumber,  // BlendWeight, BlendRadius or the distance is NaN
	OutOfRadius, // at the BlendRadius or beyond
};

struct FVolumeInfluence
{
	float Weight = 0.0f; // 0..1
	EVolumeSkip Skip = EVolumeSkip::None;
};

/** Weight of a volume at a distance, cm (not looked at where it is unbound): linear, 1 inside, 0 at the BlendRadius; a
 * radius below 1 gives the full weight to where it ends. Times the clamped BlendWeight. */
DRYDOCK_API FVolumeInfluence GetInfluence(const FPostProcessVolumeProperties& Volume, double Distance);

/** "out of radius: 520.0 cm away, BlendRadius 100.0"; empty for None. */
DRYDOCK_API std::string ExplainSkip(EVolumeSkip Skip, const FPostProcessVolumeProperties& Volume, double Distance);

} // namespace Drydock
