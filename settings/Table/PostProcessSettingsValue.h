// Holds a value of the settings table without its C++ type, and the names of a field's type and way of blending.
#pragma once

#include "CoreMinimal.h"

class UObject;

namespace Drydock
{

enum class ESettingType : uint8
{
	Float,
	Bool,
	Int,
	Enum,
	Color,
	Vector2,
	Vector4,
	Object,     // a texture or curve, by path
	ColorArray, // eight colours
};

/** The way a settings object of some weight changes a field it overrides. */
enum class ESettingBlend : uint8
{
	Lerp,          // component-wise, linear; weight 1 assigns exactly
	Set,           // assigned at any weight above 0
	SetIfNonZero,  // assigned at any weight above 0, unless the value is zero or null
	FocalDistance, // assigned where either side is 0 (switched off), else Lerp
	Accumulate,    // a contribution of its own beside all others (ambient cubemap): a list of the final settings holds
				   // it, and the field itself does not move
	LUT,           // also a list (ColorGradingLUT, ColorGradingIntensity): contributions share a weight of 1 by LerpTo
};

/** Enough for eight colours. */
constexpr int32 MaxSettingComponents = 32;

/** A value of any type of the table. Exact for all of them: numbers in doubles; bool 0 or 1; enum its number;
 * components of colours and vectors in order; the object itself. Unused components are 0. */
struct FSettingValue
{
	ESettingType Type = ESettingType::Float;
	double Components[MaxSettingComponents] = {};
	UObject* Object = nullptr;

	bool operator==(const FSettingValue&) const = default;
	/** Whether no component is NaN or infinite. */
	DRYDOCK_API bool IsFinite() const;
};

/** "Lerp", "Float", ... */
DRYDOCK_API const char* ToString(ESettingBlend Blend);
DRYDOCK_API const char* ToString(ESettingType Type);

} // namespace Drydock
