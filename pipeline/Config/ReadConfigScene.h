// Reads the objects "scene", "view" and "views" of a config.
#pragma once

#include "Config/Config.h"
#include "Config/ConfigReader.h"
#include "Text/Json.h"

namespace Drydock
{

/** Mistakes go to Messages, with their places. */
void ReadScene(const FJsonValue& Value, FConfigScene& Scene, FConfigMessages& Messages);
void ReadView(const FJsonValue& Value, FConfigView& View, FConfigMessages& Messages);

/** Reads several views: each has its rect, and the first one is used where there can be only one. */
void ReadViews(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages);

} // namespace Drydock
