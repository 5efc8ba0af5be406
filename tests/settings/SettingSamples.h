// Values to test settings with, of any field.
#pragma once

#include "PostProcessSettingsReflection.h"

namespace Drydock
{

/** A value that differs from the default in every component, which the field's type can hold. */
inline FSettingValue MakeOtherValue(const FSettingField& Field)
{
	FSettingValue Value = Field.Default;
	switch (Field.Type)
	{
	case ESettingType::Bool:
		Value.Components[0] = 1.0 - Value.Components[0];
		break;
	case ESettingType::Enum:
		Value.Components[0] = Field.EnumNames.Num() - 1 - Value.Components[0];
		Value.Components[0] = Value.Components[0] == Field.Default.Components[0] ? 0.0 : Value.Components[0];
		break;
	case ESettingType::Int:
		Value.Components[0] += 1.0;
		break;
	case ESettingType::Object:
		Value.Object = Field.FindOrAddObject("/Game/Test/Other.Other");
		break;
	default:
		for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
		{
			Value.Components[Index] += 0.25 * (Index + 1);
		}
		break;
	}
	FPostProcessSettings Scratch;
	Field.Set(Scratch, Value);
	return Field.Get(Scratch);
}

/** Fields as parameters of a test: INSTANTIATE_TEST_SUITE_P(Name, Suite, AllSettingFields(), NameOfSetting). */
inline std::vector<const FSettingField*> GetSettingFieldPointers()
{
	std::vector<const FSettingField*> Fields;
	for (const FSettingField& Field : GetSettingFields())
	{
		Fields.push_back(&Field);
	}
	return Fields;
}

} // namespace Drydock

#define AllSettingFields() testing::ValuesIn(Drydock::GetSettingFieldPointers())

struct FNameOfSetting
{
	template<typename T>
	std::string operator()(const T& Info) const
	{
		return Info.param->Name;
	}
};
