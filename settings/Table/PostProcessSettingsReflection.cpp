// Makes the fields of the settings table from its lines, and finds them by name.
#include "PostProcessSettingsReflection.h"

#include "PostProcessSettingsBlending.h"
#include "RangeTools.h"

#include <algorithm>
#include <utility>
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

/** The override bit of one setting: a bit has no address that a field could hold. */
struct FOverrideBit
{
	const char* Name;
	bool (*Get)(const FPostProcessSettings& Settings);
	void (*Set)(FPostProcessSettings& Settings, bool bOverridden);
};

/** Adds one line of the table, whose value is the member. There is one function for each type of setting: one for each
 * setting takes the compiler seven times as long. */
template<typename T>
void AddField(std::vector<FSettingField>& Fields, const char* Name, T FPostProcessSettings::*Member,
	const FOverrideBit& Bit, const FPostProcessSettings& Defaults, const FSettingRange& Range, const char* Unit,
	const char* Category, ESettingBlend Blend, const char* Doc)
{
	using FTraits = TSettingTraits<T>;
	const auto BlendBy = [Member](ESettingBlend Rule)
	{
		return [Member, Rule](FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
		{
			BlendValue(Settings.*Member, Source.*Member, Weight, Rule);
		};
	};
	Fields.push_back({
		.Name = Name,
		.Type = FTraits::Type,
		.Range = Range,
		.Unit = Unit,
		.Category = Category,
		.Blend = Blend,
		.Doc = Doc,
		.Default = FTraits::Pack(Defaults.*Member),
		.EnumNames = FTraits::GetEnumNames(),
		.OverrideName = Bit.Name,
		.ObjectClass = FTraits::GetObjectClass().Name,
		.bInterpolates = TIsInterpolable<T>,
		.Get = [Member](const FPostProcessSettings& Settings) { return FTraits::Pack(Settings.*Member); },
		.Set = [Member](FPostProcessSettings& Settings, const FSettingValue& Value)
		{ FTraits::Store(Settings.*Member, Value); },
		.IsOverridden = Bit.Get,
		.SetOverridden = Bit.Set,
		.BlendFrom = BlendBy(Blend),
		.LerpFrom = BlendBy(ESettingBlend::Lerp),
		.FindOrAddObject = FTraits::GetObjectClass().FindOrAdd,
	});
}

std::vector<FSettingField> MakeSettingFields()
{
	const FPostProcessSettings Defaults;
	std::vector<FSettingField> Fields;
#define DRYDOCK_SETTING_BIT(InType, InName, InBit, InDefault, InRange, InUnit, InCategory, InBlend, InDoc) \
	AddField<InType>(Fields, #InName, &FPostProcessSettings::InName, \
		{"bOverride_" #InBit, [](const FPostProcessSettings& Settings) -> bool { return Settings.bOverride_##InBit; }, \
			[](FPostProcessSettings& Settings, bool bOverridden) \
			{ \
				Settings.bOverride_##InBit = bOverridden ? 1 : 0; \
			}}, \
		Defaults, InRange, InUnit, InCategory, ESettingBlend::InBlend, InDoc);
#define DRYDOCK_SETTING(InType, InName, InDefault, InRange, InUnit, InCategory, InBlend, InDoc) \
	DRYDOCK_SETTING_BIT(InType, InName, InName, InDefault, InRange, InUnit, InCategory, InBlend, InDoc)
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_SETTING
	return Fields;
}

} // namespace

int32 FSettingField::GetNumComponents() const
{
	return Type == ESettingType::Color || Type == ESettingType::Vector4 ? 4
		   : Type == ESettingType::Vector2                              ? 2
		   : Type == ESettingType::ColorArray                           ? MaxSettingComponents
		   : Type == ESettingType::Object                               ? 0
																		: 1;
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

bool IsBloomStrength(std::string_view Name, std::string_view Category, bool bNumber)
{
	return bNumber && Category == "Lens|Bloom" && Name.ends_with("Intensity") && !Name.starts_with("BloomConvolution");
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
		std::ranges::count_if(Fields, [](const FSettingField& Field) { return Field.AddedId == 0; }));
}

const FSettingField* FindSettingField(const std::string& Name)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	return FindItem(Fields, Name, &FSettingField::Name);
}

FSettingValue SetSettingDefault(const std::string& Name, const FSettingValue& Value)
{
	std::vector<FSettingField>& Fields = GetMutableSettingFields();
	return std::exchange(std::ranges::find(Fields, Name, &FSettingField::Name)->Default, Value);
}

void StartWithDefaults(FPostProcessSettings& Settings)
{
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Field.AddedId == 0 && !(Field.Get(Settings) == Field.Default))
		{
			Field.Set(Settings, Field.Default);
		}
	}
}

const FSettingField* FindSettingFieldByOverride(const std::string& OverrideName)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	return FindItem(Fields, OverrideName, &FSettingField::OverrideName);
}

std::vector<std::string> GetSettingNames()
{
	return ToVector<std::string>(GetSettingFields(), &FSettingField::Name);
}

} // namespace Drydock
