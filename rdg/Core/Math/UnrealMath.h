// All mathematical types under their engine header. Source: engine Math/UnrealMath.h.
#pragma once

#include "CoreMinimal.h"
