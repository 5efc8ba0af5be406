// A settings object made ready for blending: which fields it overrides is found once, not at every blend. Source:
// drydock; the rules are engine FSceneView::OverridePostProcessSettings.
#pragma once

#include "BlendLedger.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Indices in GetSettingFields(), ascending. */
struct FOverriddenFields
{
	std::vector<uint32> Fields;    // overridden, with finite values: these blend
	std::vector<uint32> NonFinite; // overridden, but NaN or infinite: never to enter a blend
	bool bHuge = false;            // some value is so large that a difference of two may overflow
};

DRYDOCK_API FOverriddenFields FindOverriddenFields(const FPostProcessSettings& Settings);

/** Blends one field of Source into Settings by its rule and marks it overridden there. Both values are finite, and so
 * is the result where bHuge is true or no value is huge. Weight: above 0, at most 1. */
DRYDOCK_API void BlendField(const FSettingField& Field, FPostProcessSettings& Settings,
	const FPostProcessSettings& Source, float Weight, bool bHuge);

/** Whether a value of this field, though overridden, leaves what it is blended into as it is: zero and null where the
 * rule is SetIfNonZero. */
DRYDOCK_API bool IsIneffective(const FSettingField& Field, const FSettingValue& Value);

/** Whether every component is a finite number. */
DRYDOCK_API bool IsFinite(const FSettingValue& Value);

} // namespace Drydock
