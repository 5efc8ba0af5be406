// The types that reflection knows without declaring them under their engine header. Source: engine
// UObject/NoExportTypes.h.
#pragma once

#include "CoreMinimal.h"
