// Describes a setting as its declaration in C++ needs it: from a line of the table, or a setting that does not exist
// yet.
#pragma once

#include "PostProcessSettingsReflection.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A setting as its declaration needs it. */
struct FNewSetting
{
	std::string Name;
	std::string Type = "float";     // in C++: "float", "FLinearColor", "TObjectPtr<class UTexture2D>", ...
	std::string Default;            // in C++: "0.675f"
	std::string Range = "Anything"; // in the table's words
	std::string Unit;
	std::string ClampMin; // in C++; empty: none
	std::string ClampMax;
	std::string UIMax;
	std::string Category = "Lens";
	std::string Doc;
	ESettingBlend Blend = ESettingBlend::Lerp;
	std::string OverrideName; // "bOverride_BloomIntensity"
	int NumElements = 1;      // of a static array
	bool bInTable = false;
};

/** A line of drydock's table. */
DRYDOCK_API FNewSetting DescribeNewSetting(const FSettingField& Field);

/** Types that DescribeNewSetting and the table know: "float", "bool", "int32", "FLinearColor", "FVector2D", "FVector4".
 */
DRYDOCK_API const std::vector<std::string>& GetNewSettingTypes();

/** Makes a new setting from arguments. Type: one of GetNewSettingTypes; `color` and similar names are accepted.
 * Default: a number, true or false, or components `1,1,1,1`; empty: zeros. On failure returns nothing, with what was
 * expected in OutError. */
DRYDOCK_API std::optional<FNewSetting> MakeNewSetting(
	const std::string& Name, const std::string& Type, const std::string& Default, std::string& OutError);

/** The line of PostProcessSettingsTable.h. */
DRYDOCK_API std::string MakeTableLine(const FNewSetting& Setting);

} // namespace Drydock
