// Shared pointers under their engine header. Source: engine Templates/SharedPointerInternals.h.
#pragma once

#include "Templates/SharedPointer.h"
