// Post-process settings built up in parts, without a view: another rule than a world's volumes have, and on purpose not
// shared with it (FinalPostProcessSettings.h). Source: engine Engine/PostProcessUtils.h.
#pragma once

#include "PostProcessSettings.h"

struct FPostProcessUtils
{
	/** Blends ThisFrom towards OtherTo in place: every field that either of them overrides, so that a value may blend
	 * from its default or back to it; it is overridden afterwards. Numbers, colours and vectors blend linearly. A type
	 * without values in between (enums, bools, whole numbers, textures, ambient cubemap and LUT too) takes OtherTo's
	 * value above one half; so does a focal distance where one side is 0, switched off (drydock). Blendables stay as
	 * they are. BlendFactor is clamped to 0..1, 1 assigns exactly; NaN does nothing, nor do values that are not finite.
	 * Returns whether any field was blended. */
	DRYDOCK_API static bool BlendPostProcessSettings(
		FPostProcessSettings& ThisFrom, const FPostProcessSettings& OtherTo, float BlendFactor);

	/** Lays OtherTo over ThisFrom: copies the fields that OtherTo overrides, null textures too, and their bits. Returns
	 * whether any field was copied. */
	DRYDOCK_API static bool OverridePostProcessSettings(
		FPostProcessSettings& ThisFrom, const FPostProcessSettings& OtherTo);
};
