// Platform types under their engine header. Source: engine HAL/PlatformCrt.h.
#pragma once

#include "CoreTypes.h"
