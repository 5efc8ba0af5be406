// Weak object pointers under their engine header. Source: engine UObject/WeakObjectPtrTemplates.h.
#pragma once

#include "UObject/Object.h"
