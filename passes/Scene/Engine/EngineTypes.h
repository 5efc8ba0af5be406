// The enumerations lie in EngineBaseTypes.h. Source: engine file Engine/EngineTypes.h.
#pragma once

#include "Engine/EngineBaseTypes.h"
