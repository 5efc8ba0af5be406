// A post-process setting that a plugin adds, from its own source: volumes blend it, `--pp`, configs, `drydock blend`,
// `drydock list settings` and the engine's paste text know it while the plugin is loaded.
//
//   static const Drydock::TPostProcessSetting<float> GTintStrength(TEXT("TintStrength"), 0.0f, 0.0f, 1.0f);
//   ...
//   const float Strength = GTintStrength.Get(View.FinalPostProcessSettings);
//
// In the engine the same patch is a UPROPERTY with its bOverride_ bit in FPostProcessSettings and a line in
// OverridePostProcessSettings (`drydock settings plan`); there Get(Settings) becomes Settings.TintStrength.
#pragma once

#include "AddedSettingFields.h"
#include "PostProcessSettings.h"

#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace Drydock
{

/** The optional description of a setting, beside its name and default. */
struct FPostProcessSettingInfo
{
	double Min = -std::numeric_limits<double>::infinity(); // of each component; what passes it is warned of, not cut
	double Max = std::numeric_limits<double>::infinity();
	const TCHAR* Doc = TEXT("");
	const TCHAR* Unit = TEXT("");
	const TCHAR* Category = TEXT("Plugin");   // levels separated by |
	std::optional<ESettingBlend> Blend = {};  // Lerp where the type has values between two values, else Set
	std::vector<const TCHAR*> EnumNames = {}; // of an enum: names of 0, 1, 2, ...
};

/** float, bool, int32, an enum, FLinearColor, FVector2D, FVector2f, FVector4 or FVector4f. Static, in the plugin: the
 * setting is there as long as it. One that cannot be added is an error of the plugin (DD2128, DD2129). */
template<typename T>
class TPostProcessSetting : private FNoncopyable
{
public:
	TPostProcessSetting(const TCHAR* Name, const T& InDefault, const FPostProcessSettingInfo& Info = {})
		: Default(InDefault)
	{
		FAddedSetting Setting{.Name = Name, .Type = Type, .Default = Pack(Default), .Min = Info.Min, .Max = Info.Max};
		constexpr bool bInterpolates =
			Type != ESettingType::Bool && Type != ESettingType::Int && Type != ESettingType::Enum;
		Setting.Blend = Info.Blend.value_or(bInterpolates ? ESettingBlend::Lerp : ESettingBlend::Set);
		Setting.Unit = Info.Unit;
		Setting.Category = Info.Category;
		Setting.Doc = Info.Doc;
		Setting.EnumNames.assign(Info.EnumNames.begin(), Info.EnumNames.end());
		Id = AddSettingField(Setting);
	}
	TPostProcessSetting(const TCHAR* Name, const T& InDefault, double Min, double Max, const TCHAR* Doc = TEXT(""))
		: TPostProcessSetting(Name, InDefault, FPostProcessSettingInfo{.Min = Min, .Max = Max, .Doc = Doc})
	{
	}
	~TPostProcessSetting() { RemoveSettingField(Id); }

	/** The setting's value; the default if none was given. */
	T Get(const FPostProcessSettings& Settings) const
	{
		const FAddedSettings::FEntry* const Entry = Settings.AddedSettings.Find(Id);
		return Entry != nullptr ? Unpack(Entry->Value) : Default;
	}
	bool IsOverridden(const FPostProcessSettings& Settings) const
	{
		const FAddedSettings::FEntry* const Entry = Settings.AddedSettings.Find(Id);
		return Entry != nullptr && Entry->bOverridden;
	}
	/** Gives the value and sets the override bit; in the final settings (SetupView) the value alone counts. */
	void Set(FPostProcessSettings& Settings, const T& Value) const
	{
		if (Id != 0)
		{
			Settings.AddedSettings.Edit(Id, Pack(Default)) = {Pack(Value), true};
		}
	}

private:
	static constexpr bool bVector2 = std::is_same_v<T, FVector2D> || std::is_same_v<T, FVector2f>;
	static constexpr bool bVector4 = std::is_same_v<T, FVector4> || std::is_same_v<T, FVector4f>;
	static constexpr bool bColor = std::is_same_v<T, FLinearColor>;
	static_assert(bVector2 || bVector4 || bColor || std::is_same_v<T, float> || std::is_same_v<T, bool> ||
					  std::is_same_v<T, int32> || std::is_enum_v<T>,
		"a setting is a float, bool, int32, enum, FLinearColor, FVector2D, FVector2f, FVector4 or FVector4f");
	static constexpr ESettingType Type = bVector2                   ? ESettingType::Vector2
										 : bVector4                 ? ESettingType::Vector4
										 : bColor                   ? ESettingType::Color
										 : std::is_same_v<T, float> ? ESettingType::Float
										 : std::is_same_v<T, bool>  ? ESettingType::Bool
										 : std::is_same_v<T, int32> ? ESettingType::Int
																	: ESettingType::Enum;

	static FSettingValue Pack(const T& Value)
	{
		if constexpr (bColor)
		{
			return {Type, {Value.R, Value.G, Value.B, Value.A}};
		}
		else if constexpr (bVector2)
		{
			return {Type, {Value.X, Value.Y}};
		}
		else if constexpr (bVector4)
		{
			return {Type, {Value.X, Value.Y, Value.Z, Value.W}};
		}
		else
		{
			return {Type, {static_cast<double>(Value)}};
		}
	}

	static T Unpack(const FSettingValue& Value)
	{
		const double* const Numbers = Value.Components;
		if constexpr (bColor)
		{
			return FLinearColor(static_cast<float>(Numbers[0]), static_cast<float>(Numbers[1]),
				static_cast<float>(Numbers[2]), static_cast<float>(Numbers[3]));
		}
		else if constexpr (bVector2)
		{
			using FNumber = decltype(T::X);
			return T(static_cast<FNumber>(Numbers[0]), static_cast<FNumber>(Numbers[1]));
		}
		else if constexpr (bVector4)
		{
			using FNumber = decltype(T::X);
			return T(static_cast<FNumber>(Numbers[0]), static_cast<FNumber>(Numbers[1]),
				static_cast<FNumber>(Numbers[2]), static_cast<FNumber>(Numbers[3]));
		}
		else if constexpr (std::is_enum_v<T>)
		{
			return static_cast<T>(static_cast<int32>(Numbers[0]));
		}
		else
		{
			return static_cast<T>(Numbers[0]);
		}
	}

	T Default;
	uint32 Id = 0; // 0: refused
};

} // namespace Drydock
