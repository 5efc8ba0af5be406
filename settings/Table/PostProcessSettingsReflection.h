// The settings table as data: every field with its type, default, range, unit, category and blend rule, and a way to
// read and write it in any settings object. JSON, `--pp`, the schema and the lists are built on it.
#pragma once

#include "PostProcessSettings.h"
#include "PostProcessSettingsValue.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** Infinite where there is no bound. The clamps warn when passed and are not enforced; the UI bounds are where an
 * editor's slider ends. */
struct FSettingRange
{
	double ClampMin;
	double ClampMax;
	double UIMin;
	double UIMax;
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
	const char* OverrideName;               // "bOverride_BloomIntensity"
	const char* ObjectClass;                // "Texture2D", without the U; empty for other types
	bool bInterpolates;                     // whether the type has values between two values

	std::function<FSettingValue(const FPostProcessSettings& Settings)> Get;
	/** Value: of this field's type. Leaves the override bit alone. */
	std::function<void(FPostProcessSettings& Settings, const FSettingValue& Value)> Set;
	std::function<bool(const FPostProcessSettings& Settings)> IsOverridden;
	std::function<void(FPostProcessSettings& Settings, bool bOverridden)> SetOverridden;
	/** Blends Source's value into Settings by the field's rule, whatever the override bit is. Weight: 0..1; 1 assigns
	 * exactly; 0 and NaN do nothing, nor does a source that is not finite. */
	std::function<void(FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)> BlendFrom;
	/** The same without the field's rule: linear where the type interpolates, else Source's value. */
	std::function<void(FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)> LerpFrom;
	/** The object of a path, null for "None"; null pointer where ObjectClass is empty. */
	UObject* (*FindOrAddObject)(const std::string& Path);

	/** Id of a setting that a plugin added (AddedSettings.h); 0: the setting is in the table. */
	uint32 AddedId = 0;

	/** 1 for numbers, 4 for colours, ..., 0 for objects. */
	DRYDOCK_API int32 GetNumComponents() const;
	/** Whether every component lies within the clamps. */
	DRYDOCK_API bool IsInRange(const FSettingValue& Value) const;
};

/** Whether a setting multiplies the bloom, by the engine's names: a number "...Intensity" of the bloom's category. The
 * intensity of convolution bloom alone has names of its own. */
DRYDOCK_API bool IsBloomStrength(std::string_view Name, std::string_view Category, bool bNumber);

/** All fields in the order of the table; behind them those that plugins have added. */
DRYDOCK_API const std::vector<FSettingField>& GetSettingFields();

/** The same list for AddedSettingFields.cpp, which adds to it and takes away. */
std::vector<FSettingField>& GetMutableSettingFields();

/** Those of the table are the first ones of GetSettingFields(). */
DRYDOCK_API size_t GetNumTableSettings();

/** Null when no field has exactly this name. */
DRYDOCK_API const FSettingField* FindSettingField(const std::string& Name);

/** The field of an override bit's whole name, such as "bOverride_BloomIntensity"; null when there is none. */
DRYDOCK_API const FSettingField* FindSettingFieldByOverride(const std::string& OverrideName);

/** Gives a field another default, with which every view begins. Returns the one of before. */
DRYDOCK_API FSettingValue SetSettingDefault(const std::string& Name, const FSettingValue& Value);

/** Puts defaults that were changed so into new settings. */
DRYDOCK_API void StartWithDefaults(FPostProcessSettings& Settings);

/** Names of all fields, for suggestions. */
DRYDOCK_API std::vector<std::string> GetSettingNames();

/** `0.675`, `true`, `BM_SOG`, `[1, 1, 1, 1]`, `/Game/Dirt.Dirt`, `None`: the shortest text that reads back to the same
 * value, valid JSON but for the quotes of an enum's name or a path. */
DRYDOCK_API std::string SettingToText(const FSettingField& Field, const FSettingValue& Value);

/** The same as JSON: names and paths in quotes, no object as null. */
DRYDOCK_API std::string SettingToJson(const FSettingField& Field, const FSettingValue& Value);

/** Reads what SettingToText writes, and spaces around it; enums also by number, bools also as 0 and 1, colours also
 * with three components (alpha 1) or in the engine's form `(R=1,G=1,B=1,A=1)`, objects also with their class
 * (`Texture2D'/Game/A.A'`). On failure returns false with what was
 * expected in OutError. */
DRYDOCK_API bool SettingFromText(
	const FSettingField& Field, const std::string& Text, FSettingValue& OutValue, std::string& OutError);

} // namespace Drydock
