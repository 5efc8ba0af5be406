// Settings that plugins add to the table while they are loaded. Plugins use PostProcessSetting.h.
#pragma once

#include "Diagnostics.h"
#include "PostProcessSettingsValue.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The description of a setting that is to be added. */
struct FAddedSetting
{
	std::string Name;
	ESettingType Type = ESettingType::Float; // all but Object and ColorArray
	FSettingValue Default;
	double Min = 0.0; // infinite where there is no bound; what passes one is warned of and used as it is
	double Max = 0.0;
	ESettingBlend Blend = ESettingBlend::Lerp;
	std::string Unit = {};
	std::string Category = {};
	std::string Doc = {};
	std::vector<std::string> EnumNames = {}; // index = number
};

/** Adds a field behind those of the table, for all that reads GetSettingFields(): from one to the next registration
 * references to fields and their indices hold. Returns its number, never used again; 0 where it is refused: a name that
 * another setting has (DD2128), or values that make no sense (DD2129); TakeSettingProblems reports the reason. */
DRYDOCK_API uint32 AddSettingField(const FAddedSetting& Setting);

/** Values of it that settings objects have are forgotten with them. 0 does nothing. */
DRYDOCK_API void RemoveSettingField(uint32 Id);

/** Why settings were refused since the last call. */
DRYDOCK_API std::vector<FDiagnostic> TakeSettingProblems();

} // namespace Drydock
