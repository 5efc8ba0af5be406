// Writes every place that an engine patch for one setting touches, as text to copy: from the table's line, or from that
// of a new setting. Names of files, structs and macros: engine 5.4; which places there are: the toon-bloom article and
// the engine's rules for settings.
#pragma once

#include "NewSetting.h"

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

/** In the order of the engine's data flow: declaration, default, blending, switching off, pass, shader. */
DRYDOCK_API std::vector<FSettingPlace> MakeSettingPlan(const FNewSetting& Setting);

/** The plan to read: numbered places with their text. */
DRYDOCK_API std::string FormatSettingPlan(const FNewSetting& Setting);

} // namespace Drydock
