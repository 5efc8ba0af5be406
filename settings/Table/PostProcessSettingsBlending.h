// The blend rules on single values. For PostProcessSettingsReflection.cpp. Source: engine LERP_PP, SET_PP and IF_PP of
// FSceneView::OverridePostProcessSettings; that weight 1 assigns and that non-finite sources stay out is drydock's.
#pragma once

#include "PostProcessSettingsTraits.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace Drydock
{

/** Linear blending in the precision of the type: float settings blend in float, as in the engine. If the difference of
 * two finite ends overflows, the blend is computed without it. */
template<typename T>
T LerpNumber(T From, T To, float Weight)
{
	const T Result = From + static_cast<T>(Weight) * (To - From);
	return std::isfinite(Result) ? Result : From * (T(1) - static_cast<T>(Weight)) + To * static_cast<T>(Weight);
}

inline float LerpValue(float From, float To, float Weight)
{
	return LerpNumber(From, To, Weight);
}

inline FLinearColor LerpValue(const FLinearColor& From, const FLinearColor& To, float Weight)
{
	return FLinearColor(LerpNumber(From.R, To.R, Weight), LerpNumber(From.G, To.G, Weight),
		LerpNumber(From.B, To.B, Weight), LerpNumber(From.A, To.A, Weight));
}

inline FVector2D LerpValue(const FVector2D& From, const FVector2D& To, float Weight)
{
	return FVector2D(LerpNumber(From.X, To.X, Weight), LerpNumber(From.Y, To.Y, Weight));
}

inline FVector4 LerpValue(const FVector4& From, const FVector4& To, float Weight)
{
	return FVector4(LerpNumber(From.X, To.X, Weight), LerpNumber(From.Y, To.Y, Weight),
		LerpNumber(From.Z, To.Z, Weight), LerpNumber(From.W, To.W, Weight));
}

template<typename T>
constexpr bool TIsInterpolable =
	std::is_same_v<T, float> || std::is_same_v<T, FLinearColor> || std::is_same_v<T, FVector2D> ||
	std::is_same_v<T, FVector4> || std::is_same_v<T, FLensFlareTints>;

/** Weight in 0..1; 1 assigns, and so does any weight where the type cannot be interpolated. */
template<typename T>
void LerpTo(T& Target, const T& Source, float Weight)
{
	if constexpr (std::is_array_v<T>)
	{
		for (size_t Index = 0; Index < std::extent_v<T>; ++Index)
		{
			LerpTo(Target[Index], Source[Index], Weight);
		}
	}
	else if constexpr (TIsInterpolable<T>)
	{
		Target = Weight < 1.0f ? LerpValue(Target, Source, Weight) : Source;
	}
	else
	{
		Target = Source;
	}
}

template<typename T>
bool IsZero(const T& Value)
{
	const FSettingValue Packed = TSettingTraits<T>::Pack(Value);
	return Packed.Object == nullptr && std::all_of(std::begin(Packed.Components), std::end(Packed.Components),
										   [](double Component) { return Component == 0.0; });
}

template<typename T>
bool IsFinite(const T& Value)
{
	if constexpr (std::is_floating_point_v<T>)
	{
		return std::isfinite(Value);
	}
	else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>)
	{
		return true;
	}
	else
	{
		return TSettingTraits<T>::Pack(Value).IsFinite();
	}
}

template<typename T>
void BlendValue(T& Target, const T& Source, float Weight, ESettingBlend Blend)
{
	if (!(Weight > 0.0f) || !IsFinite(Source))
	{
		return;
	}
	switch (Blend)
	{
	case ESettingBlend::Lerp:
		LerpTo(Target, Source, Weight);
		break;
	case ESettingBlend::Set:
		LerpTo(Target, Source, 1.0f);
		break;
	case ESettingBlend::SetIfNonZero:
		if (!IsZero(Source))
		{
			LerpTo(Target, Source, 1.0f);
		}
		break;
	case ESettingBlend::FocalDistance:
		LerpTo(Target, Source, IsZero(Target) || IsZero(Source) ? 1.0f : Weight);
		break;
	case ESettingBlend::Accumulate:
	case ESettingBlend::LUT:
		break;
	}
}

} // namespace Drydock
