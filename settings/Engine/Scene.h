// The engine's path to FPostProcessSettings. Source: engine Engine/Scene.h.
#pragma once

#include "PostProcessSettings.h"

#ifndef UPROPERTY
/** Reflection here comes from the settings table; the engine's markup is accepted and ignored. */
#define UPROPERTY(...)
#endif
