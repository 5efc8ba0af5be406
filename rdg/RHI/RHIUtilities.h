// Stands under the engine's name for RHI.h, which has what code takes from it. Source: engine RHIUtilities.h.
#pragma once

#include "RHI.h"
