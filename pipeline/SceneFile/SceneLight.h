// Reads the colour of a rendered frame's main light, for lighting after rendering. See configs/scenes/README.md.
#pragma once

#include "CoreMinimal.h"

#include <optional>
#include <string>

namespace Drydock
{

/** The colour that a drydock:camera_json text gives as main_light_color, relative: divided by its largest component,
 * because the frame already contains the light's strength. Empty if the text has none, or a value that is not a colour:
 * other than three finite numbers, a negative one, black. */
DRYDOCK_API std::optional<FLinearColor> ReadSceneLightColor(const std::string& Json);

} // namespace Drydock
