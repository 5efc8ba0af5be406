// Strong object pointers under their engine header. Source: engine UObject/StrongObjectPtr.h.
#pragma once

#include "UObject/Object.h"
