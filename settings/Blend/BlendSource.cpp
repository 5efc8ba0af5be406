// Finds the fields that a settings object overrides, and reports values that have no effect.
#include "BlendSource.h"

#include <algorithm>

namespace Drydock
{

FOverriddenFields FindOverriddenFields(const FPostProcessSettings& Settings)
{
	FOverriddenFields Found;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (uint32 Index = 0; Index < Fields.size(); ++Index)
	{
		if (Fields[Index].IsOverridden(Settings))
		{
			(Fields[Index].Get(Settings).IsFinite() ? Found.Fields : Found.NonFinite).push_back(Index);
		}
	}
	return Found;
}

bool IsIneffective(const FSettingField& Field, const FSettingValue& Value)
{
	return Field.Blend == ESettingBlend::SetIfNonZero && Value.Object == nullptr &&
		   std::ranges::all_of(Value.Components, [](double Component) { return Component == 0.0; });
}

} // namespace Drydock
