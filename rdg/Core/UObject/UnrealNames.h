// Predefined names under their engine header. Source: engine UObject/UnrealNames.h.
#pragma once

#include "UObject/NameTypes.h"
