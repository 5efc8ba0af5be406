// Casts between objects under their engine header. Source: engine Templates/Casts.h.
#pragma once

#include "UObject/Object.h"
