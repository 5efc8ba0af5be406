// The table of settings for readers: text of 80 columns, and JSON.
#pragma once

#include "PostProcessSettingsReflection.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Fields whose name contains the pattern, or matches it where it has * or ?; upper and lower case are the same. */
DRYDOCK_API std::vector<const FSettingField*> FindSettingFields(const std::string& Pattern);

/** `>= 0`, `0 .. 1`, or nothing. */
DRYDOCK_API std::string FormatSettingRange(const FSettingField& Field);

/** Under a heading for each category: name, type, default, range, unit and rule, then what it is. */
DRYDOCK_API std::string FormatSettings(const std::vector<const FSettingField*>& Fields);

/** An array of objects: name, override, type, default (a value), range (text), min and max (null without bound), unit,
 * blend, category, doc; values of enums, class of objects. */
DRYDOCK_API std::string FormatSettingsJson(const std::vector<const FSettingField*>& Fields);

} // namespace Drydock
