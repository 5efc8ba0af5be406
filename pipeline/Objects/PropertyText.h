// Reads values of an ini file by the type of their property: numbers, True and False, names, and the engine's text of
// structs and arrays, (X=1,Y=2) and (1,2,3).
#pragma once

#include "Objects/IniText.h"
#include "UObject/Reflection.h"

#include <optional>
#include <vector>

namespace Drydock
{

/** The value for a property of that type; nothing if the text has no form of such a value. WriteProperty decides
 * whether the property takes the value. */
DRYDOCK_API std::optional<FPropertyValue> ReadPropertyText(
	const FPropertyType& Type, const std::vector<FIniValue>& Values);

} // namespace Drydock
