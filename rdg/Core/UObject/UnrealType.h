// Property types under their engine header. Source: engine UObject/UnrealType.h.
#pragma once

#include "UObject/ObjectMacros.h"
