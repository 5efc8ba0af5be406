// ON_SCOPE_EXIT and TGuardValue under their engine header. Source: engine Misc/ScopeExit.h.
#pragma once

#include "Templates/UnrealTemplate.h"
