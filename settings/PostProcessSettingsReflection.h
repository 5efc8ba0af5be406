// The settings table as data: every field with its type, default, range, unit, category and blend rule, and a way to
// read and write it in any settings object. JSON, `--pp`, the schema and the lists are built on it. Source: drydock.
#pragma once

#include "PostProcessSettings.h"

#include <string>
#include <vector>

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
};

/** What a settings object of some weight does with a field it overrides. */
enum class ESettingBlend : uint8
{
	Lerp,          // component-wise, linear; weight 1 assigns exactly
	Set,           // assigned at any weight above 0
	SetIfNonZero,  // assigned at any weight above 0, unless the value is zero or null
	FocalDistance, // assigned where either side is 0 (switched off), else Lerp
	Accumulate,    // added, times the weight
};

/** Infinite where there is no bound. The clamps warn when passed and are not enforced; the UI bounds are where an
 * editor's slider ends. */
struct FSettingRange
{
	double ClampMin;
	double ClampMax;
	double UIMin;
	double UIMax;
};

/** A value of any type of the table. Exact for all of them: numbers in doubles; bool 0 or 1; enum its number;
 * components of colours and vectors in order. */
struct FSettingValue
{
	ESettingType Type = ESettingType::Float;
	double Components[4] = {0.0, 0.0, 0.0, 0.0};

	bool operator==(const FSettingValue&) const = default;
};

struct FSettingField
{
	const char* Name;
	ESettingType Type;
	FSettingRange Range;
	const char* Unit;
	const char* Category;
	ESettingBlend Blend;
	const char* Doc;
	FSettingValue Default;
	TConstArrayView<const char*> EnumNames; // index = number; empty for other types

	FSettingValue (*Get)(const FPostProcessSettings& Settings);
	/** Value: of this field's type. Leaves the override bit alone. */
	void (*Set)(FPostProcessSettings& Settings, const FSettingValue& Value);
	bool (*IsOverridden)(const FPostProcessSettings& Settings);
	void (*SetOverridden)(FPostProcessSettings& Settings, bool bOverridden);
	/** Blends Source's value into Settings by the field's rule, whatever the override bit says. Weight: 0..1. */
	void (*BlendFrom)(FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight);

	/** 1 for numbers, 4 for colours, ... */
	DRYDOCK_API int32 GetNumComponents() const;
	/** Whether every component lies within the clamps. */
	DRYDOCK_API bool IsInRange(const FSettingValue& Value) const;
};

/** All fields in the order of the table. */
DRYDOCK_API const std::vector<FSettingField>& GetSettingFields();

/** Null when no field has exactly this name. */
DRYDOCK_API const FSettingField* FindSettingField(const std::string& Name);

/** Names of all fields, for suggestions. */
DRYDOCK_API std::vector<std::string> GetSettingNames();

/** `0.675`, `true`, `BM_SOG`, `[1, 1, 1, 1]`: the shortest text that reads back to the same value, valid JSON but for
 * the quotes of an enum's name. */
DRYDOCK_API std::string SettingToText(const FSettingField& Field, const FSettingValue& Value);

/** Reads what SettingToText writes, and spaces around it; enums also by number, bools also as 0 and 1, colours also
 * with three components (alpha 1) or in the engine's form `(R=1,G=1,B=1,A=1)`. On failure returns false with what was
 * expected in OutError. */
DRYDOCK_API bool SettingFromText(
	const FSettingField& Field, const std::string& Text, FSettingValue& OutValue, std::string& OutError);

/** "Lerp", "Float", ... */
DRYDOCK_API const char* ToString(ESettingBlend Blend);
DRYDOCK_API const char* ToString(ESettingType Type);

} // namespace Drydock
