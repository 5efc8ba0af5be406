// Stands under the engine's name for RenderingThread.h and RenderUtils.h, which have what code takes from it. Source:
// engine RenderCore.h.
#pragma once

#include "RenderUtils.h"
#include "RenderingThread.h"
