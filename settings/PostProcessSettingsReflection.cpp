// Source: drydock.
#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

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

constexpr const char* BloomMethodNames[] = {"BM_SOG", "BM_FFT"};
constexpr const char* AutoExposureMethodNames[] = {"AEM_Histogram", "AEM_Basic", "AEM_Manual"};

/** What the table's types are made of. Pack and Unpack must be inverses, bit for bit. */
template<typename T>
struct TSettingTraits;

template<typename T, ESettingType InType>
struct TScalarSettingTraits
{
	static constexpr ESettingType Type = InType;
	static FSettingValue Pack(T Value) { return {Type, {static_cast<double>(Value), 0.0, 0.0, 0.0}}; }
	static T Unpack(const FSettingValue& Value) { return static_cast<T>(Value.Components[0]); }
	static TConstArrayView<const char*> GetEnumNames() { return {}; }
};

template<>
struct TSettingTraits<float> : TScalarSettingTraits<float, ESettingType::Float>
{
};

template<>
struct TSettingTraits<int32> : TScalarSettingTraits<int32, ESettingType::Int>
{
};

template<>
struct TSettingTraits<bool> : TScalarSettingTraits<bool, ESettingType::Bool>
{
	static bool Unpack(const FSettingValue& Value) { return Value.Components[0] != 0.0; }
};

template<typename T>
struct TEnumSettingTraits
{
	static constexpr ESettingType Type = ESettingType::Enum;
	static FSettingValue Pack(T Value)
	{
		return {Type, {static_cast<double>(static_cast<int32>(Value)), 0.0, 0.0, 0.0}};
	}
	static T Unpack(const FSettingValue& Value) { return static_cast<T>(static_cast<int32>(Value.Components[0])); }
};

template<>
struct TSettingTraits<EBloomMethod> : TEnumSettingTraits<EBloomMethod>
{
	static TConstArrayView<const char*> GetEnumNames()
	{
		return TConstArrayView<const char*>(BloomMethodNames, BM_MAX);
	}
};

template<>
struct TSettingTraits<EAutoExposureMethod> : TEnumSettingTraits<EAutoExposureMethod>
{
	static TConstArrayView<const char*> GetEnumNames()
	{
		return TConstArrayView<const char*>(AutoExposureMethodNames, AEM_MAX);
	}
};

template<>
struct TSettingTraits<FLinearColor>
{
	static constexpr ESettingType Type = ESettingType::Color;
	static FSettingValue Pack(const FLinearColor& Value) { return {Type, {Value.R, Value.G, Value.B, Value.A}}; }
	static FLinearColor Unpack(const FSettingValue& Value)
	{
		return FLinearColor(static_cast<float>(Value.Components[0]), static_cast<float>(Value.Components[1]),
			static_cast<float>(Value.Components[2]), static_cast<float>(Value.Components[3]));
	}
	static TConstArrayView<const char*> GetEnumNames() { return {}; }
};

template<>
struct TSettingTraits<FVector2D>
{
	static constexpr ESettingType Type = ESettingType::Vector2;
	static FSettingValue Pack(const FVector2D& Value) { return {Type, {Value.X, Value.Y, 0.0, 0.0}}; }
	static FVector2D Unpack(const FSettingValue& Value) { return FVector2D(Value.Components[0], Value.Components[1]); }
	static TConstArrayView<const char*> GetEnumNames() { return {}; }
};

/** Linear blending in the precision of the type: float settings blend in float, as in the engine. */
float LerpValue(float From, float To, float Weight)
{
	return From + Weight * (To - From);
}

double LerpValue(double From, double To, float Weight)
{
	return From + static_cast<double>(Weight) * (To - From);
}

FLinearColor LerpValue(const FLinearColor& From, const FLinearColor& To, float Weight)
{
	return FLinearColor(LerpValue(From.R, To.R, Weight), LerpValue(From.G, To.G, Weight),
		LerpValue(From.B, To.B, Weight), LerpValue(From.A, To.A, Weight));
}

FVector2D LerpValue(const FVector2D& From, const FVector2D& To, float Weight)
{
	return FVector2D(LerpValue(From.X, To.X, Weight), LerpValue(From.Y, To.Y, Weight));
}

template<typename T>
constexpr bool TIsLerpable =
	std::is_same_v<T, float> || std::is_same_v<T, FLinearColor> || std::is_same_v<T, FVector2D>;

template<typename T>
bool IsZero(const T& Value)
{
	const FSettingValue Packed = TSettingTraits<T>::Pack(Value);
	return std::all_of(
		std::begin(Packed.Components), std::end(Packed.Components), [](double Component) { return Component == 0.0; });
}

template<typename T>
void BlendValue(T& Target, const T& Source, float Weight, ESettingBlend Blend)
{
	const bool bSourceCounts = Blend != ESettingBlend::SetIfNonZero || !IsZero(Source);
	const bool bSwitchesOnOrOff = Blend == ESettingBlend::FocalDistance && (IsZero(Target) || IsZero(Source));
	const bool bAssigns = Blend == ESettingBlend::Set || Blend == ESettingBlend::SetIfNonZero || bSwitchesOnOrOff;
	if (!(Weight > 0.0f) || !bSourceCounts)
	{
		return;
	}
	if constexpr (TIsLerpable<T>)
	{
		if (Blend == ESettingBlend::Accumulate)
		{
			Target = Target + Source * Weight;
			return;
		}
		if (!bAssigns && Weight < 1.0f)
		{
			Target = LerpValue(Target, Source, Weight);
			return;
		}
	}
	Target = Source;
}

std::vector<FSettingField> MakeSettingFields()
{
	const FPostProcessSettings Defaults;
	std::vector<FSettingField> Fields;
#define DRYDOCK_SETTING(InType, InName, InDefault, InRange, InUnit, InCategory, InBlend, InDoc) \
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
		[](const FPostProcessSettings& Settings) { return TSettingTraits<InType>::Pack(Settings.InName); }, \
		[](FPostProcessSettings& Settings, const FSettingValue& Value) \
		{ Settings.InName = TSettingTraits<InType>::Unpack(Value); }, \
		[](const FPostProcessSettings& Settings) -> bool { return Settings.bOverride_##InName; }, \
		[](FPostProcessSettings& Settings, bool bOverridden) { Settings.bOverride_##InName = bOverridden ? 1 : 0; }, \
		[](FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight) \
		{ BlendValue(Settings.InName, Source.InName, Weight, ESettingBlend::InBlend); }, \
	});
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

const std::vector<FSettingField>& GetSettingFields()
{
	static const std::vector<FSettingField> Fields = MakeSettingFields();
	return Fields;
}

const FSettingField* FindSettingField(const std::string& Name)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	const auto Found =
		std::find_if(Fields.begin(), Fields.end(), [&](const FSettingField& Field) { return Field.Name == Name; });
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
	}
	return "?";
}

} // namespace Drydock
