// Memory functions under their engine header. Source: engine HAL/PlatformMemory.h.
#pragma once

#include "HAL/UnrealMemory.h"
