// Changes single values of a config's JSON by their places, "/objects/UMySettings/Intensity".
#pragma once

#include "Text/Json.h"

#include <optional>
#include <string>

namespace Drydock
{

/** Whether a study may vary the place: in "objects", "passes" or "extensions". */
bool IsConfigPlace(const std::string& Place);

/** The value there, as the command line takes it; nothing where the config has no number, text or truth value. */
std::optional<std::string> FindPlaceText(const FJsonValue& Root, const std::string& Place);

/** "/objects/UMySettings/Intensity=0.5": the value is JSON, and else text. Members that are missing are added. Throws
 * FError (exit code 2) for an element that "passes" or "extensions" does not have. */
void SetConfigPlace(FJsonValue& Root, const std::string& Argument, const std::string& File);

} // namespace Drydock
