// sg.PostProcessQuality, 0 low to 4 cinematic: setting it sets the group's console variables, as scalability does, so
// that anyone but the constructor beats it. Nothing is applied until somebody sets it. Source: engine Scalability.h;
// values: the engine's BaseScalability settings as publicly documented (5.4), for the variables that drydock knows.
#pragma once

#include "CoreMinimal.h"

#include <array>
#include <vector>

namespace Drydock
{

constexpr int32 NumScalabilityLevels = 5;

/** One variable of the group. */
struct FScalabilityRow
{
	const char* Variable;
	/** Text by level; null: that level leaves the variable alone. */
	std::array<const char*, NumScalabilityLevels> Values;
};

/** All variables of PostProcessQuality. */
DRYDOCK_API const std::vector<FScalabilityRow>& GetPostProcessQualityRows();

/** Sets the group's variables as ECVF_SetByScalability; a variable that another source has set keeps its value, with
 * the engine's warning. Level is clamped to 0..4. */
DRYDOCK_API void ApplyPostProcessQuality(int32 Level);

} // namespace Drydock
