// Names of the table's types and blend rules, and what holds for values of any type.
#include "PostProcessSettingsValue.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

bool FSettingValue::IsFinite() const
{
	return std::ranges::all_of(Components, [](double Component) { return std::isfinite(Component); });
}

const char* ToString(ESettingBlend Blend)
{
	constexpr const char* Names[] = {"Lerp", "Set", "SetIfNonZero", "FocalDistance", "Accumulate", "LUT"};
	return Names[size_t(Blend)];
}

const char* ToString(ESettingType Type)
{
	constexpr const char* Names[] = {
		"float", "bool", "int", "enum", "color", "vector2", "vector4", "object", "color[8]"};
	return Names[size_t(Type)];
}

} // namespace Drydock
