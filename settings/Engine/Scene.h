// The engine's path to FPostProcessSettings and the settings of lenses, film and cameras. Source: engine
// Engine/Scene.h.
#pragma once

#include "PostProcessSettings.h"
#include "PostProcessSubSettings.h"

#ifndef UPROPERTY
/** Reflection here comes from the settings table; the engine's markup is accepted and ignored. */
#define UPROPERTY(...)
#endif
