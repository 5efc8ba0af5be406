// Converts the table's C++ types to FSettingValue and back: Pack and Store are inverses, bit for bit. For
// PostProcessSettingsReflection.cpp.
#pragma once

#include "Math/ToInteger.h"
#include "PostProcessSettings.h"
#include "PostProcessSettingsValue.h"
#include "SettingObjects.h"

namespace Drydock
{

/** Name and maker of a type's objects; for other types neither. */
struct FSettingObjectClass
{
	const char* Name = "";
	UObject* (*FindOrAdd)(const std::string& Path) = nullptr;
};

struct FSettingTraitsBase
{
	static TConstArrayView<const char*> GetEnumNames() { return {}; }
	static FSettingObjectClass GetObjectClass() { return {}; }
};

template<typename T>
struct TSettingTraits;

template<>
struct TSettingTraits<float> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Float;
	static FSettingValue Pack(float Value) { return {Type, {Value}}; }
	static void Store(float& Target, const FSettingValue& Value) { Target = static_cast<float>(Value.Components[0]); }
};

template<>
struct TSettingTraits<int32> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Int;
	static FSettingValue Pack(int32 Value) { return {Type, {static_cast<double>(Value)}}; }
	static void Store(int32& Target, const FSettingValue& Value) { Target = ToInteger<int32>(Value.Components[0]); }
};

template<>
struct TSettingTraits<bool> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Bool;
	static FSettingValue Pack(bool bValue) { return {Type, {bValue ? 1.0 : 0.0}}; }
	static void Store(bool& bTarget, const FSettingValue& Value) { bTarget = Value.Components[0] != 0.0; }
};

template<>
struct TSettingTraits<FLinearColor> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Color;
	static FSettingValue Pack(const FLinearColor& Value) { return {Type, {Value.R, Value.G, Value.B, Value.A}}; }
	static void Store(FLinearColor& Target, const FSettingValue& Value)
	{
		for (int32 Index = 0; Index < 4; ++Index)
		{
			Target.Component(Index) = static_cast<float>(Value.Components[Index]);
		}
	}
};

template<>
struct TSettingTraits<FLensFlareTints> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::ColorArray;
	static FSettingValue Pack(const FLensFlareTints& Value)
	{
		FSettingValue Packed{Type};
		for (int32 Index = 0; Index < MaxSettingComponents; ++Index)
		{
			Packed.Components[Index] = Value[Index / 4].Component(Index % 4);
		}
		return Packed;
	}
	static void Store(FLensFlareTints& Target, const FSettingValue& Value)
	{
		for (int32 Index = 0; Index < MaxSettingComponents; ++Index)
		{
			Target[Index / 4].Component(Index % 4) = static_cast<float>(Value.Components[Index]);
		}
	}
};

template<>
struct TSettingTraits<FVector2D> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Vector2;
	static FSettingValue Pack(const FVector2D& Value) { return {Type, {Value.X, Value.Y}}; }
	static void Store(FVector2D& Target, const FSettingValue& Value)
	{
		Target = FVector2D(Value.Components[0], Value.Components[1]);
	}
};

template<>
struct TSettingTraits<FVector4> : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Vector4;
	static FSettingValue Pack(const FVector4& Value) { return {Type, {Value.X, Value.Y, Value.Z, Value.W}}; }
	static void Store(FVector4& Target, const FSettingValue& Value)
	{
		Target = FVector4(Value.Components[0], Value.Components[1], Value.Components[2], Value.Components[3]);
	}
};

template<typename T>
struct TEnumSettingTraits : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Enum;
	static FSettingValue Pack(T Value) { return {Type, {static_cast<double>(static_cast<int32>(Value))}}; }
	static void Store(T& Target, const FSettingValue& Value)
	{
		Target = static_cast<T>(ToInteger<int32>(Value.Components[0]));
	}
};

/** Names of an enum's values from 0 on. */
#define DRYDOCK_SETTING_ENUM(Enum, ...) \
	template<> \
	struct TSettingTraits<Enum> : TEnumSettingTraits<Enum> \
	{ \
		static TConstArrayView<const char*> GetEnumNames() \
		{ \
			static constexpr const char* Names[] = {__VA_ARGS__}; \
			return TConstArrayView<const char*>(Names, static_cast<int32>(std::size(Names))); \
		} \
	}

DRYDOCK_SETTING_ENUM(ETemperatureMethod, "TEMP_WhiteBalance", "TEMP_ColorTemperature");
DRYDOCK_SETTING_ENUM(EBloomMethod, "BM_SOG", "BM_FFT");
DRYDOCK_SETTING_ENUM(EAutoExposureMethod, "AEM_Histogram", "AEM_Basic", "AEM_Manual");
DRYDOCK_SETTING_ENUM(ELocalExposureMethod, "Bilateral", "Fusion");
DRYDOCK_SETTING_ENUM(EDynamicGlobalIlluminationMethod::Type, "None", "Lumen", "ScreenSpace", "Plugin");
DRYDOCK_SETTING_ENUM(EReflectionMethod::Type, "None", "Lumen", "ScreenSpace");
DRYDOCK_SETTING_ENUM(
	ELumenRayLightingModeOverride, "Default", "SurfaceCache", "HitLightingForReflections", "HitLighting");
DRYDOCK_SETTING_ENUM(ETranslucencyType, "Raster", "RayTracing");
DRYDOCK_SETTING_ENUM(EReflectedAndRefractedRayTracedShadows, "Disabled", "Hard_shadows", "Area_shadows");
DRYDOCK_SETTING_ENUM(EToonShadowBlurStore, "EightBit", "SixteenBit", "SqrtEightBit");
DRYDOCK_SETTING_ENUM(EToonShadowBlurBlend, "Screen", "Max", "Add");
DRYDOCK_SETTING_ENUM(EDiffusionFilterBlend, "Screen", "Max");

#undef DRYDOCK_SETTING_ENUM

template<typename T>
struct TObjectSettingTraits : FSettingTraitsBase
{
	static constexpr ESettingType Type = ESettingType::Object;
	static FSettingValue Pack(const TObjectPtr<T>& Value) { return {Type, {}, Value.Get()}; }
	/** An object of another class is not a value of this type: the target becomes null. */
	static void Store(TObjectPtr<T>& Target, const FSettingValue& Value) { Target = Cast<T>(Value.Object); }
};

template<>
struct TSettingTraits<TObjectPtr<UTexture>> : TObjectSettingTraits<UTexture>
{
	static FSettingObjectClass GetObjectClass()
	{
		return {"Texture",
			[](const std::string& Path) -> UObject*
			{
				return FindOrAddTexture(Path);
			}};
	}
};

template<>
struct TSettingTraits<TObjectPtr<UTexture2D>> : TObjectSettingTraits<UTexture2D>
{
	static FSettingObjectClass GetObjectClass()
	{
		return {"Texture2D",
			[](const std::string& Path) -> UObject*
			{
				return FindOrAddTexture(Path);
			}};
	}
};

template<>
struct TSettingTraits<TObjectPtr<UTextureCube>> : TObjectSettingTraits<UTextureCube>
{
	static FSettingObjectClass GetObjectClass()
	{
		return {"TextureCube",
			[](const std::string& Path) -> UObject*
			{
				return FindOrAddTextureCube(Path);
			}};
	}
};

template<>
struct TSettingTraits<TObjectPtr<UCurveFloat>> : TObjectSettingTraits<UCurveFloat>
{
	static FSettingObjectClass GetObjectClass()
	{
		return {"CurveFloat",
			[](const std::string& Path) -> UObject*
			{
				return FindOrAddCurve(Path);
			}};
	}
};

} // namespace Drydock
