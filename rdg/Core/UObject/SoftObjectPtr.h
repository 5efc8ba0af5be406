// Soft object pointers under their engine header. Source: engine UObject/SoftObjectPtr.h.
#pragma once

#include "UObject/Object.h"
