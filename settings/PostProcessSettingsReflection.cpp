// Makes the fields of the settings table from its lines, and finds them by name.
#include "PostProcessSettingsReflection.h"

#include "PostProcessSettingsBlending.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

constexpr double NoBound = std::numeric_limits<double>::infinity();
constexpr FSettingRange Anything = {-NoBound, NoBound, -NoBound, NoBound};

constexpr FSettingRange AtLeast(double ClampMin, double UIMax)
{
	return {ClampMin, NoBound, ClampMin, UIMax};
}

constexpr FSettingRange Between(double ClampMin, double ClampMax)
{
	return {ClampMin, ClampMax, ClampMin, ClampMax};
}

constexpr FSettingRange Slider(double UIMin, double UIMax)
{
	return {-NoBound, NoBound, UIMin, UIMax};
}

std::vector<FSettingField> MakeSettingFields()
{
	const FPostProcessSettings Defaults;
	std::vector<FSettingField> Fields;
#define DRYDOCK_SETTING_BIT(InType, InName, InBit, InDefault, InRange, InUnit, InCategory, InBlend, InDoc) \
	Fields.push_back({ \
		#InName, \
		TSettingTraits<InType>::Type, \
		InRange, \
		InUnit, \
		InCategory, \
		ESettingBlend::InBlend, \
		InDoc, \
		TSettingTraits<InType>::Pack(Defaults.InName), \
		TSettingTraits<InType>::GetEnumNames(), \
		"bOverride_" #InBit, \
		TSettingTraits<InType>::GetObjectClass().Name, \
		TIsInterpolable<InType>, \
		[](const FPostProcessSettings& Settings) { return TSettingTraits<InType>::Pack(Settings.InName); }, \
		[](FPostProcessSettings& Settings, const FSettingValue& Value) \
		{ TSettingTraits<InType>::Store(Settings.InName, Value); }, \
		[](const FPostProcessSettings& Settings) -> bool { return Settings.bOverride_##InBit; }, \
		[](FPostProcessSettings& Settings, bool bOverridden) { Settings.bOverride_##InBit = bOverridden ? 1 : 0; }, \
		[](FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight) \
		{ BlendValue(Settings.InName, Source.InName, Weight, ESettingBlend::InBlend); }, \
		[](FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight) \
		{ BlendValue(Settings.InName, Source.InName, Weight, ESettingBlend::Lerp); }, \
		TSettingTraits<InType>::GetObjectClass().FindOrAdd, \
	});
#define DRYDOCK_SETTING(InType, InName, InDefault, InRange, InUnit, InCategory, InBlend, InDoc) \
	DRYDOCK_SETTING_BIT(InType, InName, InName, InDefault, InRange, InUnit, InCategory, InBlend, InDoc)
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_SETTING
	return Fields;
}

} // namespace

int32 FSettingField::GetNumComponents() const
{
	switch (Type)
	{
	case ESettingType::Color:
	case ESettingType::Vector4:
		return 4;
	case ESettingType::Vector2:
		return 2;
	case ESettingType::ColorArray:
		return MaxSettingComponents;
	case ESettingType::Object:
		return 0;
	default:
		return 1;
	}
}

bool FSettingField::IsInRange(const FSettingValue& Value) const
{
	for (int32 Index = 0; Index < GetNumComponents(); ++Index)
	{
		if (!(Value.Components[Index] >= Range.ClampMin && Value.Components[Index] <= Range.ClampMax))
		{
			return false;
		}
	}
	return true;
}

std::vector<FSettingField>& GetMutableSettingFields()
{
	// Never destroyed: plugins take theirs away at the very end of the program.
	static auto* const Fields = new std::vector<FSettingField>(MakeSettingFields());
	return *Fields;
}

const std::vector<FSettingField>& GetSettingFields()
{
	return GetMutableSettingFields();
}

size_t GetNumTableSettings()
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	return static_cast<size_t>(
		std::count_if(Fields.begin(), Fields.end(), [](const FSettingField& Field) { return Field.AddedId == 0; }));
}

const FSettingField* FindSettingField(const std::string& Name)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	const auto Found =
		std::find_if(Fields.begin(), Fields.end(), [&](const FSettingField& Field) { return Field.Name == Name; });
	return Found == Fields.end() ? nullptr : &*Found;
}

const FSettingField* FindSettingFieldByOverride(const std::string& OverrideName)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	const auto Found = std::find_if(
		Fields.begin(), Fields.end(), [&](const FSettingField& Field) { return Field.OverrideName == OverrideName; });
	return Found == Fields.end() ? nullptr : &*Found;
}

std::vector<std::string> GetSettingNames()
{
	std::vector<std::string> Names;
	for (const FSettingField& Field : GetSettingFields())
	{
		Names.emplace_back(Field.Name);
	}
	return Names;
}

} // namespace Drydock
