// Statistics macros under their engine header. Source: engine Stats/Stats2.h.
#pragma once

#include "Stats/Stats.h"
