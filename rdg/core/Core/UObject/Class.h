// UClass, which stands in UObject/Object.h: each needs the other. Source of the name: engine UObject/Class.h.
#pragma once

#include "UObject/Object.h"
