// Prepares a settings object for blending: the fields that it overrides are found once, not at every blend.
#pragma once

#include "PostProcessSettingsReflection.h"

#include <vector>

namespace Drydock
{

/** Indices in GetSettingFields(), ascending. */
struct FOverriddenFields
{
	std::vector<uint32> Fields;    // overridden, with finite values: these blend
	std::vector<uint32> NonFinite; // overridden, but NaN or infinite: never to enter a blend
};

DRYDOCK_API FOverriddenFields FindOverriddenFields(const FPostProcessSettings& Settings);

/** Whether a value of this field, though overridden, leaves what it is blended into as it is: zero and null where the
 * rule is SetIfNonZero. */
DRYDOCK_API bool IsIneffective(const FSettingField& Field, const FSettingValue& Value);

} // namespace Drydock
