// Platform mathematics under their engine header. Source: engine HAL/PlatformMath.h.
#pragma once

#include "Math/UnrealMathUtility.h"
