// Type traits under their engine header. Source: engine Templates/UnrealTypeTraits.h.
#pragma once

#include "Templates/UnrealTemplate.h"
