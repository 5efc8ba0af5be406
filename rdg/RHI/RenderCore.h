// Source: engine RenderCore.h. What code takes from it lies in RenderingThread.h and RenderUtils.h.
#pragma once

#include "RenderUtils.h"
#include "RenderingThread.h"
