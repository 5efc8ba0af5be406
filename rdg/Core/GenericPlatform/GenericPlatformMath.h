// Platform mathematics under their engine header. Source: engine GenericPlatform/GenericPlatformMath.h.
#pragma once

#include "Math/UnrealMathUtility.h"
