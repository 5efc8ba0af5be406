// NewObject, GetDefault and the like under their engine header. Source: engine UObject/UObjectGlobals.h.
#pragma once

#include "UObject/Object.h"
