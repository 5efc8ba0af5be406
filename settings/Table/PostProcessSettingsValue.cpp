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
	switch (Blend)
	{
	case ESettingBlend::Lerp:
		return "Lerp";
	case ESettingBlend::Set:
		return "Set";
	case ESettingBlend::SetIfNonZero:
		return "SetIfNonZero";
	case ESettingBlend::FocalDistance:
		return "FocalDistance";
	case ESettingBlend::Accumulate:
		return "Accumulate";
	case ESettingBlend::LUT:
		return "LUT";
	}
	return "?";
}

const char* ToString(ESettingType Type)
{
	switch (Type)
	{
	case ESettingType::Float:
		return "float";
	case ESettingType::Bool:
		return "bool";
	case ESettingType::Int:
		return "int";
	case ESettingType::Enum:
		return "enum";
	case ESettingType::Color:
		return "color";
	case ESettingType::Vector2:
		return "vector2";
	case ESettingType::Vector4:
		return "vector4";
	case ESettingType::Object:
		return "object";
	case ESettingType::ColorArray:
		return "color[8]";
	}
	return "?";
}

} // namespace Drydock
