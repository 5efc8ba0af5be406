// The colour of a rendered frame's main light, for what is lit after rendering. See configs/scenes/README.md.
#pragma once

#include "CoreMinimal.h"

#include <optional>
#include <string>

namespace Drydock
{

/** The colour that a drydock:camera_json text says as main_light_color, relative: divided by its largest component,
 * because how strong the light is lies in the frame already. Empty if the text has none or a value that is not
 * three finite numbers, has a negative one, or is black. */
DRYDOCK_API std::optional<FLinearColor> ReadSceneLightColor(const std::string& Json);

} // namespace Drydock
