// Platform types and switches under their engine header. Source: engine HAL/Platform.h.
#pragma once

#include "CoreTypes.h"
