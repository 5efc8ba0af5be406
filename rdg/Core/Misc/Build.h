// Build switches under their engine header. Source: engine Misc/Build.h.
#pragma once

#include "CoreTypes.h"
