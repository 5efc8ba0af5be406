// GEngine. Source: engine file EngineGlobals.h.
#pragma once

#include "Engine/Engine.h"
