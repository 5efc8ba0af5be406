// Blends settings objects as the engine's utility for code does. Source: engine PostProcessUtils.cpp, from its
// documentation.
#include "Engine/PostProcessUtils.h"

#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <cmath>

namespace
{

/** Whether the field has values between the two. */
bool HasValuesBetween(
	const Drydock::FSettingField& Field, const Drydock::FSettingValue& From, const Drydock::FSettingValue& To)
{
	const bool bSwitches =
		Field.Blend == Drydock::ESettingBlend::FocalDistance && (From.Components[0] == 0.0 || To.Components[0] == 0.0);
	return Field.bInterpolates && !bSwitches;
}

} // namespace

bool FPostProcessUtils::BlendPostProcessSettings(
	FPostProcessSettings& ThisFrom, const FPostProcessSettings& OtherTo, float BlendFactor)
{
	if (std::isnan(BlendFactor))
	{
		return false;
	}
	const float Weight = std::clamp(BlendFactor, 0.0f, 1.0f);
	bool bAny = false;
	for (const Drydock::FSettingField& Field : Drydock::GetSettingFields())
	{
		const Drydock::FSettingValue To = Field.Get(OtherTo);
		if ((!Field.IsOverridden(ThisFrom) && !Field.IsOverridden(OtherTo)) || !To.IsFinite())
		{
			continue;
		}
		const bool bBetween = HasValuesBetween(Field, Field.Get(ThisFrom), To);
		Field.LerpFrom(ThisFrom, OtherTo, bBetween ? Weight : (Weight > 0.5f ? 1.0f : 0.0f));
		Field.SetOverridden(ThisFrom, true);
		bAny = true;
	}
	return bAny;
}

bool FPostProcessUtils::OverridePostProcessSettings(FPostProcessSettings& ThisFrom, const FPostProcessSettings& OtherTo)
{
	bool bAny = false;
	for (const Drydock::FSettingField& Field : Drydock::GetSettingFields())
	{
		const Drydock::FSettingValue To = Field.Get(OtherTo);
		if (Field.IsOverridden(OtherTo) && To.IsFinite())
		{
			Field.Set(ThisFrom, To);
			Field.SetOverridden(ThisFrom, true);
			bAny = true;
		}
	}
	return bAny;
}
