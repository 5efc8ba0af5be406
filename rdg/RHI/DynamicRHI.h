// Source: engine DynamicRHI.h. What code takes from it lies in RHI.h.
#pragma once

#include "RHI.h"
