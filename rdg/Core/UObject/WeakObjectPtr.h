// Weak object pointers under their engine header. Source: engine UObject/WeakObjectPtr.h.
#pragma once

#include "UObject/Object.h"
