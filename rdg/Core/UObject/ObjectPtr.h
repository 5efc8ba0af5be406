// Object pointers under their engine header. Source: engine UObject/ObjectPtr.h.
#pragma once

#include "UObject/Object.h"
