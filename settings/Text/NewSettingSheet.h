// Writes every place that an engine patch for one setting touches, as text to copy: from the table's line, or from that
// of a new setting. Names of files, structs and macros: engine 5.4; which places there are: the toon-bloom article and
// the engine's rules for settings.
#pragma once

#include "NewSetting.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** One place to edit. */
struct FSettingPlace
{
	std::string File;  // "Engine/Source/Runtime/Engine/Classes/Engine/Scene.h"
	std::string Where; // "FPostProcessSettings, among the override bits"
	std::string Text;  // lines to add, without indentation
	std::string Why;   // what happens without it; may be empty
};

/** How the bloom setup masks what a strength of bloom is for. */
enum class ESettingPlanForm : uint8_t
{
	Corrected, // each full-resolution pixel has its own id
	Printed    // as the article on toon bloom has it: one id for a half-resolution pixel
};

/** Each place once, with the lines of all settings. Files stand in the order of the engine's data flow: declaration,
 * default, blending, switching off, pass, shader. */
DRYDOCK_API std::vector<FSettingPlace> MakeSettingPlan(
	const std::vector<FNewSetting>& Settings, ESettingPlanForm Form = ESettingPlanForm::Corrected);

/** The plan to read: numbered places with their text. */
DRYDOCK_API std::string FormatSettingPlan(
	const std::vector<FNewSetting>& Settings, ESettingPlanForm Form = ESettingPlanForm::Corrected);

} // namespace Drydock
