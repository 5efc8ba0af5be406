// Forwards under the engine's path. Source: engine file PostProcess/PostProcessTonemap.h.
#pragma once

#include <Tonemap/PostProcessTonemap.h>
