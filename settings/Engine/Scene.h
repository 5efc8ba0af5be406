// The engine's path to FPostProcessSettings and the settings of lenses, film and cameras. Reflection comes from the
// settings table; the engine's markup (UPROPERTY and the like) is accepted and ignored. Source: engine Engine/Scene.h.
#pragma once

#include "PostProcessSettings.h"
#include "PostProcessSubSettings.h"
#include "UObject/ObjectMacros.h"
